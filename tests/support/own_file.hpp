#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

namespace brunt::test {

/// A path for a file or folder that no other test has: tests run side by side, each a process.
inline std::string own_file(const std::string& name) {
  return ::testing::TempDir() + "brunt_" + std::to_string(getpid()) + "_" + name;
}

}  // namespace brunt::test
