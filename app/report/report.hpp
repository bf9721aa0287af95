#pragma once
#include <string>
#include <vector>

namespace brunt {

/// `brunt report`: a page report.html in each output folder, which needs nothing beside it.
/// Returns the exit status: 2 where a folder holds no run that has ended.
int report_command(const std::vector<std::string>& folders);

}  // namespace brunt
