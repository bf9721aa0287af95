#pragma once
/// The number types, labels and small vectors that every layer shares.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace brunt {

using Real = double;
using GlobalId = std::uint64_t;   ///< from the deck, never from a counter that depends on ranks
using LocalIndex = std::int32_t;  ///< position in an array of this rank
using Label = std::uint32_t;      ///< body or piece

/// Where an entry stands in a std::vector or an array: an index that is signed or narrow, or an
/// enumerator, as their own type. An index below 0 becomes one beyond any end.
template <class Index>
requires std::integral<Index> || std::is_enum_v<Index>
constexpr std::size_t slot_of(Index index) noexcept { return static_cast<std::size_t>(index); }

template <int Dim>
using Vec = Eigen::Matrix<Real, Dim, 1>;
using Vec3 = Vec<3>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;

/// The vector in space; what a plane scene leaves out is 0.
template <int Dim>
Vec3 in_space(const Vec<Dim>& v) {
  Vec3 space = Vec3::Zero();
  space.template head<Dim>() = v;
  return space;
}

inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
inline constexpr Real kPi = 3.14159265358979323846;

/// What the two coordinates of a 2D deck mean; a 3D deck is three_d.
enum class Geometry : std::uint8_t { three_d, plane_strain, axisymmetric };

/// Names of the components of a vector.
inline constexpr const char* kAxes[] = {"x", "y", "z"};

/// Components of a symmetric tensor, in the order in which every array of brunt stores them.
enum SymmetricIndex : int { xx = 0, yy = 1, zz = 2, xy = 3, yz = 4, zx = 5 };

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
