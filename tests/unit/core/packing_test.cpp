#include "core/parallel/packing.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(Packing, ValuesComeOutInTheirOrder) {
  const std::vector<Real> numbers = {1.5, -2, 1e300};
  const std::vector<Label> none;
  const Bytes bytes = (Packer() << Label(7) << numbers << std::string("bar") << none).take();
  Label label = 0;
  std::vector<Real> found;
  std::string text;
  std::vector<Label> empty = {1, 2};
  Unpacker from(bytes);
  from >> label >> found >> text >> empty;
  EXPECT_EQ(label, 7U);
  EXPECT_EQ(found, numbers);
  EXPECT_EQ(text, "bar");
  EXPECT_TRUE(empty.empty());
  EXPECT_TRUE(from.done());
}

TEST(Packing, AMessageThatIsCutShortIsRefusedAtEveryLength) {
  const Bytes whole = (Packer() << std::vector<Real>{1, 2} << std::string("bar")).take();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    Unpacker from(part);
    std::vector<Real> numbers;
    std::string text;
    EXPECT_THROW(from >> numbers >> text, MachineError) << size;
  }
}

// A length that is damaged must not ask for all memory.
TEST(Packing, ALengthBeyondTheMessageIsRefused) {
  const Bytes bytes = (Packer() << std::uint64_t(1) << Real(0)).take();
  const Bytes damaged = (Packer() << ~std::uint64_t(0) << Real(0)).take();
  std::vector<Real> values;
  Unpacker(bytes) >> values;
  EXPECT_EQ(values, std::vector<Real>{0});
  EXPECT_THROW(Unpacker(damaged) >> values, MachineError);
}

TEST(Packing, WhatIsTakenIsLeftEmpty) {
  Packer packer;
  EXPECT_TRUE(packer.empty());
  packer << Label(1);
  EXPECT_FALSE(packer.empty());
}

}  // namespace
}  // namespace brunt
