#pragma once
#include <string>

namespace brunt {

/// docs/columns.md: unit and meaning of each column of history.csv and of each field of frames.
std::string columns_page();

}  // namespace brunt
