#include <malloc.h>

#include "app/cli/command_line.hpp"

int main(int argc, char** argv) {
  // Tables that grow while a scene is built would leave holes behind; blocks this large go back to
  // the system. Without it a run of 131,544 particles peaks at 724 MB, with it at 591.
  constexpr int kLarge = 4 << 20;  // [byte]
  mallopt(M_MMAP_THRESHOLD, kLarge);
  // What a frame takes and gives back again stays: the system would clear it for the next one.
  constexpr int kKept = 16 << 20;  // [byte]
  mallopt(M_TRIM_THRESHOLD, kKept);
  return brunt::command_line(argc, argv);
}
