#include "app/reference.hpp"

#include "app/run_arguments.hpp"

namespace brunt {

int explain_command(const std::string&) { return kDone; }
int schema_command(bool) { return kDone; }

}  // namespace brunt
