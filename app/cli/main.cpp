#include "app/cli/command_line.hpp"

int main(int argc, char** argv) { return brunt::command_line(argc, argv); }
