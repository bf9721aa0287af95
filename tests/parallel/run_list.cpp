// Runs brunt many times in one process, or on the ranks that mpirun started: a lone call of mpirun
// takes longer than most of the runs that are compared here.
//   run_list FILE    one call of brunt after another, or, for whoever gives brunt's own words:
//   run_list run DECK ...
// FILE: of each run its folder, then the words of the command line, one a line, then an empty line.
// What a run says goes to FOLDER.err; its folder is printed when it starts. Ends with the first run
// that fails, with its status.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "core/parallel/communicator.hpp"

namespace {
/// The next run of a list; empty at its end.
std::vector<std::string> next_run(std::istream& list) {
  std::vector<std::string> words;
  for (std::string line; std::getline(list, line) && !line.empty();) words.push_back(line);
  return words;
}

/// One call of brunt; `words`: the folder and the command line.
int run(std::vector<std::string> words) {
  const std::string said = words[0] + ".err";
  const int file = open(said.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (file < 0 || dup2(file, STDERR_FILENO) < 0) return 4;
  close(file);
  words[0] = "brunt";
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return brunt::command_line(static_cast<int>(words.size()), arguments.data());
}
}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return brunt::command_line(argc, argv);
  const brunt::ParallelSession session(argc, argv);
  std::ifstream list(argv[1]);
  if (!list) return 2;
  for (auto words = next_run(list); !words.empty(); words = next_run(list)) {
    if (session.ranks().is_root()) std::puts(words[0].c_str());
    if (const int status = run(std::move(words)); status != 0) return status;
  }
  return 0;
}
