#include "io/stl.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

namespace brunt {

namespace {
constexpr std::uintmax_t kMostBytes = 128u << 20;
constexpr std::size_t kHeader = 80, kCount = 4, kRecord = 50, kNormal = 12;  // [byte]

/// Corners by their places, and triangles by their corners.
class Merger {
 public:
  explicit Merger(StlSurface& surface) : surface_(surface) {}
  void add(const std::array<Vec3, 3>& corner) {
    std::array<int, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) triangle[c] = node_at(corner[c]);
    const Vec3 area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const bool same =
        triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
    if (same || !(area.squaredNorm() > 0)) {
      ++surface_.degenerate;
    } else {
      surface_.triangles.push_back(triangle);
    }
  }

 private:
  int node_at(const Vec3& x) {
    // 0 + -0 is 0: both are one place.
    const std::array<Real, 3> key{x[0] + 0.0, x[1] + 0.0, x[2] + 0.0};
    const auto [it, is_new] = known_.try_emplace(key, static_cast<int>(surface_.nodes.size()));
    if (is_new) surface_.nodes.emplace_back(key[0], key[1], key[2]);
    return it->second;
  }

  StlSurface& surface_;
  std::map<std::array<Real, 3>, int> known_;
};

bool is_finite(const std::array<Vec3, 3>& corner) {
  for (const Vec3& x : corner) {
    if (!std::isfinite(x[0] + x[1] + x[2])) return false;
  }
  return true;
}

std::uint32_t triangle_count(const std::string& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeader + kCount) std::memcpy(&count, bytes.data() + kHeader, kCount);
  return count;
}

/// Text files begin with "solid", but so do some binary ones: their size decides.
bool is_binary(const std::string& bytes) {
  if (bytes.size() < kHeader + kCount) return false;
  const std::size_t size = kHeader + kCount + kRecord * std::size_t{triangle_count(bytes)};
  return bytes.size() == size || bytes.rfind("solid", 0) != 0;
}

void read_binary(const std::string& path, const std::string& bytes, Merger& merger) {
  const std::size_t count = triangle_count(bytes);
  const std::size_t wanted = kHeader + kCount + kRecord * count;
  if (bytes.size() < wanted) {
    throw std::runtime_error(path + ": is cut off: it has " + std::to_string(bytes.size()) +
                             " bytes, and " + std::to_string(count) + " triangles take " +
                             std::to_string(wanted));
  }
  for (std::size_t t = 0; t < count; ++t) {
    std::array<Vec3, 3> corner;
    const char* at = bytes.data() + kHeader + kCount + kRecord * t + kNormal;
    for (Vec3& x : corner) {
      float value[3];
      std::memcpy(value, at, sizeof value);
      at += sizeof value;
      x = Vec3(value[0], value[1], value[2]);
    }
    if (!is_finite(corner)) {
      throw std::runtime_error(path + ": triangle " + std::to_string(t + 1) + " is no number");
    }
    merger.add(corner);
  }
}

void read_text(const std::string& path, const std::string& bytes, Merger& merger) {
  std::istringstream lines(bytes);
  std::string line, word;
  std::array<Vec3, 3> corner;
  std::size_t number = 0, corners = 0;
  const auto wrong = [&](const std::string& what) {
    throw std::runtime_error(path + ":" + std::to_string(number) + ": " + what);
  };
  while (std::getline(lines, line)) {
    ++number;
    std::istringstream words(line);
    if (!(words >> word)) continue;
    if (word == "facet") {
      corners = 0;
    } else if (word == "vertex") {
      if (corners == 3) wrong("a fourth vertex: only triangles are known");
      Vec3& x = corner[corners++];
      if (!(words >> x[0] >> x[1] >> x[2])) wrong("a vertex has three numbers");
    } else if (word == "endfacet") {
      if (corners != 3) wrong("the triangle has " + std::to_string(corners) + " vertices");
      merger.add(corner);
      corners = 0;
    } else if (word != "solid" && word != "outer" && word != "endloop" && word != "endsolid") {
      wrong("'" + word + "' is not a word of an STL file");
    }
  }
  if (corners != 0) wrong("the file ends inside a triangle");
}
/// Refuses what would not end: pipes, devices, files beyond any surface.
void require_readable(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto type = fs::status(path, error).type();
  if (type == fs::file_type::not_found) throw std::runtime_error(path + ": there is no such file");
  if (type == fs::file_type::none) throw std::runtime_error(path + ": " + error.message());
  if (type != fs::file_type::regular) {
    throw std::runtime_error(path + ": is a folder, a pipe or a device; STL is read from a file");
  }
  if (fs::file_size(path, error) > kMostBytes) {
    throw std::runtime_error(path +
                             ": is larger than 128 MiB, some 2.7 million triangles: "
                             "reduce it to what the particles or elements can resolve");
  }
}
}  // namespace

StlSurface read_stl(const std::string& path) {
  require_readable(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": there is no such file, or it cannot be read");
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  StlSurface surface;
  Merger merger(surface);
  if (is_binary(bytes)) {
    read_binary(path, bytes, merger);
  } else {
    read_text(path, bytes, merger);
  }
  if (surface.triangles.empty()) throw std::runtime_error(path + ": there is no triangle in it");
  return surface;
}

}  // namespace brunt
