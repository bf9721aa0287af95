#include "tests/support/random_deck.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "core/types.hpp"

namespace brunt::test {

namespace {
/// std's distributions differ from library to library; its generator does not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed * 0x9e3779b97f4a7c15u + 1) {}
  Real unit() { return static_cast<Real>(random_() >> 11) * 0x1p-53; }
  Real between(Real low, Real high) { return low + (high - low) * unit(); }
  Real log_between(Real low, Real high) { return low * std::pow(high / low, unit()); }
  bool chance(Real probability) { return unit() < probability; }
  std::size_t one_of(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  template <std::size_t N>
  std::string word(const char* const (&words)[N]) {
    return words[one_of(N)];
  }

 private:
  std::mt19937_64 random_;
};

std::string text(Real value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

struct Solid {
  Real density, modulus, poisson, yield;  // [kg/m^3], [Pa], [1], [Pa]
};
constexpr Solid kSolids[] = {{7850, 200e9, 0.3, 400e6},   {2700, 70e9, 0.33, 250e6},
                             {8960, 124e9, 0.34, 90e6},   {11340, 16e9, 0.42, 15e6},
                             {1150, 3e9, 0.38, 60e6},     {1000, 10e6, 0.45, 5e6},
                             {19300, 400e9, 0.28, 1.2e9}, {2400, 30e9, 0.2, 30e6}};

enum class Kind { fe, sph, free_rigid, floor };

class Writer {
 public:
  Writer(std::uint64_t seed, bool newer)
      : dice_(seed), more_(seed + 0x5eed), newer_(newer), seed_(seed) {}

  std::string deck() {
    dimensions_ = dice_.chance(0.5) ? 3 : 2;
    axisymmetric_ = dimensions_ == 2 && dice_.chance(0.4);
    const std::size_t n_bodies = 2 + dice_.one_of(2);
    std::string bodies;
    for (std::size_t b = 0; b < n_bodies; ++b) bodies += body(b, n_bodies);
    std::string deck = "title: random deck " + std::to_string(seed_) + "\n";
    if (dimensions_ == 2) {
      deck += std::string("geometry: ") + (axisymmetric_ ? "axisymmetric" : "plane-strain") + "\n";
    }
    const Real step = 0.5 * shortest_;
    const Real end = std::min(step * dice_.between(300, 1500), 8e-3 / fastest_);
    deck += "time: {end: " + text(end) + ", min_step: " + text(step / 40) + "}\n";
    deck += "heat: " + dice_.word({"auto", "auto", "off"}) + "\n";
    deck += "materials:\n" + materials_ + "bodies:\n" + bodies + contact() + boundaries();
    if (!particles_ && draws(0.2)) deck += symmetry();
    if (dice_.chance(0.2)) {
      deck += std::string("gravity: ") + (dimensions_ == 3 ? "[0, 0, -9.81]" : "[0, -9.81]") + "\n";
    }
    if (dice_.chance(0.1)) deck += "damping: {rate: " + text(dice_.log_between(10, 1e4)) + "}\n";
    return deck;
  }

 private:
  /// Draws a material for a body and returns its speed of sound [m/s].
  Real material(const std::string& name) {
    const Solid& solid = kSolids[dice_.one_of(std::size(kSolids))];
    const Real density = solid.density * dice_.between(0.9, 1.1);
    const Real E = solid.modulus * dice_.between(0.7, 1.3), nu = solid.poisson;
    const Real yield = solid.yield * dice_.log_between(0.5, 2);
    const Real bulk = E / (3 * (1 - 2 * nu));
    if (draws(0.3)) return other_material(name, density, E, yield);
    std::string line = "  " + name + ": {density: " + text(density) + ", elastic: {E: " + text(E) +
                       ", nu: " + text(nu) + "}";
    const bool thermal = dice_.chance(0.5);
    switch (dice_.one_of(4)) {
      case 0:
        break;
      case 1:
        line += ", strength: {j2: {yield: " + text(yield) +
                (dice_.chance(0.5) ? ", hardening: " + text(yield * dice_.unit()) : "") + "}}";
        break;
      case 2:
        line += ", strength: {j2: {yield: " + text(yield) + ", hardening: {table: [[0, 0], [0.1, " +
                text(0.3 * yield) + "], [1, " + text(yield) + "]], over: eps_p}}}";
        break;
      default:
        line += ", strength: {johnson-cook: {A: " + text(yield) + ", B: " + text(yield) +
                ", n: " + text(dice_.between(0.1, 0.8)) + ", C: 0.02, m: 1" +
                (thermal ? ", T_melt: 1200" : "") + "}}";
    }
    yields_ = line.find("strength") != std::string::npos;
    if (yields_ && draws(0.4)) line += ", damage: " + damage(yield);
    if (dice_.chance(0.3)) {
      line += ", eos: {mie-gruneisen: {c0: " + text(std::sqrt(bulk / density)) +
              ", s: " + text(dice_.between(1, 1.6)) + ", gamma0: " + text(dice_.between(1, 2.2)) +
              "}}";
    }
    if (dice_.chance(0.15)) line += ", tensile_cutoff: " + text(3 * yield);
    if (thermal) {
      line += ", thermal: {cp: " + text(dice_.between(130, 1000));
      if (dice_.chance(0.6)) line += ", k: " + text(dice_.log_between(0.2, 400));
      line += "}";
    }
    materials_ += line + "}\n";
    const Real shear = E / (2 * (1 + nu));
    return std::sqrt((bulk + 4.0 / 3 * shear) / density);
  }

  /// True by chance, where newer features are drawn.
  bool draws(Real probability) { return newer_ && more_.chance(probability); }

  std::string damage(Real yield) {
    failing_ = true;
    const std::string energy =
        more_.chance(0.5) ? ", energy: " + text(more_.log_between(10, 1e5)) : "";
    switch (more_.one_of(5)) {
      case 0:
        return "{strain: " + text(more_.log_between(0.01, 1)) + energy + "}";
      case 1:
        return "{cockcroft_latham: " + text(yield * more_.log_between(0.01, 1)) + energy + "}";
      case 2:
        return "{principal_stress: " + text(yield * more_.log_between(0.1, 2)) + energy + "}";
      case 3:
        return "{mean_tension: " + text(yield * more_.log_between(0.1, 2)) + energy + "}";
      default:
        return "{johnson-cook: {D1: " + text(more_.between(0.01, 0.3)) +
               ", D2: " + text(more_.between(0, 2)) + ", D3: -1.5, D4: 0.01" + energy + "}}";
    }
  }

  /// Liquids, gases, explosives and concrete; returns the speed of sound [m/s].
  Real other_material(const std::string& name, Real density, Real E, Real yield) {
    const Real c = std::sqrt(E / density);
    const std::size_t choice = more_.one_of(6);
    if (choice == 3) density = 1630;  // of the explosive
    const std::string begin = "  " + name + ": {density: " + text(density);
    std::string rest;
    Real sound = c;
    switch (choice) {
      case 0:
        rest =
            ", eos: {tait: {c0: " + text(c) + (more_.chance(0.5) ? ", pressure: 1e5" : "") + "}}";
        break;
      case 1:
        rest = ", elastic: {E: " + text(E) + ", nu: 0.3}, eos: {polynomial: {C1: " + text(E) +
               ", C2: " + text(E) + ", C3: " + text(0.5 * E) +
               ", C4: " + text(more_.between(0, 2)) + ", C5: " + text(more_.between(0, 1)) +
               "}}, strength: {j2: {yield: " + text(yield) + "}}";
        sound = 1.3 * c;
        break;
      case 2:
        rest =
            ", eos: {ideal-gas: {gamma: 1.4, pressure: " + text(more_.log_between(1e5, 1e9)) + "}}";
        sound = std::sqrt(1.4e9 / density);
        break;
      case 3:
        rest = ", eos: {jwl: {A: 371.2e9, B: 3.231e9, R1: 4.15, R2: 0.95, omega: 0.3, E0: 7e9}}";
        sound = 4e3;
        break;
      case 4: {
        const Real fc = more_.log_between(10e6, 100e6);
        rest = ", strength: {concrete-cap: {fc: " + text(fc) +
               ", Gf: " + text(more_.log_between(30, 300)) + "}}";
        sound = std::sqrt(34e9 / density);
        break;
      }
      default:
        rest =
            ", strength: {hjc: {fc: 48e6, G: 14.86e9, A: 0.79, B: 1.6, N: 0.61, C: 0.007, "
            "T: 4e6, D1: 0.04, ef_min: 0.01, p_crush: 16e6, mu_crush: 0.001, p_lock: 800e6, "
            "mu_lock: 0.1, K1: 85e9, K2: -171e9, K3: 208e9}}";
        sound = std::sqrt(100e9 / density);
    }
    materials_ += begin + rest + "}\n";
    return sound;
  }

  std::string erosion() {
    std::string how;
    if (failing_ && more_.chance(0.7)) how += ", damage: true";
    if (yields_ && more_.chance(0.4)) how += ", strain: " + text(more_.log_between(0.1, 2));
    if (how.empty() || more_.chance(0.3)) how += ", inverted: true";
    const std::string to = more_.chance(0.3) ? ", to: nothing" : "";
    return ", erode: {when: {" + how.substr(2) + "}" + to + "}";
  }

  std::string symmetry() {
    return std::string("symmetry: {") + (dimensions_ == 3 ? "z" : "y") + ": 0}\n";
  }

  std::string vector(Real across, Real along) {
    if (dimensions_ == 2) return "[" + text(axisymmetric_ ? 0 : across) + ", " + text(along) + "]";
    return "[" + text(across) + ", " + text(0.3 * across) + ", " + text(along) + "]";
  }

  /// A shape whose lowest point along the way is at `bottom`; sets its height.
  std::string shape(Kind kind, Real width, Real bottom, Real aside, Real& height) {
    height = width * dice_.between(0.6, 2);
    const bool flat = dimensions_ == 2;
    const std::size_t choice = dice_.one_of(flat ? 3 : 4);
    const Real r = 0.5 * width;
    if (choice == 0 && !axisymmetric_) {
      height = width;
      const std::string at = flat ? "[" + text(aside) + ", " + text(bottom + r) + "]"
                                  : "[" + text(aside) + ", 0, " + text(bottom + r) + "]";
      return "{sphere: {radius: " + text(r) + ", center: " + at + "}}";
    }
    if (choice == 1 && !flat && kind != Kind::sph) {
      return "{cylinder: {radius: " + text(r) + ", length: " + text(height) + ", base: [" +
             text(aside) + ", 0, " + text(bottom) + "], axis: z}}";
    }
    if (choice == 2 && !flat) {
      return "{tube: {inner: " + text(0.5 * r) + ", outer: " + text(r) +
             ", length: " + text(height) + ", base: [" + text(aside) + ", 0, " + text(bottom) +
             "], axis: z}}";
    }
    const std::string low =
        axisymmetric_ ? "[0, " + text(bottom) + "]"
        : flat        ? "[" + text(aside - r) + ", " + text(bottom) + "]"
                      : "[" + text(aside - r) + ", " + text(-r) + ", " + text(bottom) + "]";
    const std::string high =
        axisymmetric_ ? "[" + text(r) + ", " + text(bottom + height) + "]"
        : flat        ? "[" + text(aside + r) + ", " + text(bottom + height) + "]"
                      : "[" + text(aside + r) + ", " + text(r) + ", " + text(bottom + height) + "]";
    return "{box: {min: " + low + ", max: " + high + "}}";
  }

  std::string element_options() {
    switch (dice_.one_of(6)) {
      case 0:
        return ", element: {integration: q1p0}";
      case 1:
        return ", element: {integration: full}";
      case 2:
        return ", element: {hourglass: " +
               dice_.word({"{viscous: 0.1}", "{stiffness: 0.05}", "{assumed_strain: 1}"}) + "}";
      default:
        return "";
    }
  }

  std::string particle_options() {
    std::string options;
    if (draws(0.2)) {
      return ", formulation: total" + std::string(draws(0.3) ? ", hourglass: 5" : "") +
             (draws(0.3) ? ", lattice: hexagonal, smoothing: 1.4" : "");
    }
    if (dice_.chance(0.3)) options += ", lattice: hexagonal";
    if (dice_.chance(0.2)) options += ", kernel: " + dice_.word({"wendland-c2", "quadratic"});
    if (dice_.chance(0.1)) options += ", artificial_stress: 0.3, smoothing: 1.2";
    if (dice_.chance(0.1)) options += ", correction: false";
    return options;
  }

  std::string body(std::size_t b, std::size_t n_bodies) {
    const std::string name = "b" + std::to_string(b);
    Kind kind = Kind::fe;
    const Real draw = dice_.unit();
    if (draw > 0.55) kind = axisymmetric_ ? Kind::fe : Kind::sph;
    if (draw > 0.85) kind = Kind::free_rigid;
    if (b == 0 && dice_.chance(0.3)) kind = Kind::floor;
    if (b + 1 == n_bodies && kind == Kind::free_rigid) kind = Kind::fe;  // one that deforms
    if (kind == Kind::floor) {
      top_ = 0;
      const std::string origin = axisymmetric_ ? "[0.05, 0]" : vector(0, 0);
      return "  " + name + ": {rigid: true, shape: {plane: {origin: " + origin +
             ", normal: " + (dimensions_ == 3 ? "z" : "y") + ", extent: 0.1}}}\n";
    }
    const Real width = dice_.between(3e-3, 8e-3);
    Real height = 0;
    const Real n_across = dice_.between(kind == Kind::sph ? 4 : 2, dimensions_ == 3 ? 6 : 12);
    const Real size = width / n_across;
    // Particles stand half a spacing inside of what is drawn.
    const Real gap = dice_.chance(0.4) ? 0 : size * dice_.log_between(0.01, 1);
    const Real aside = axisymmetric_ || dice_.chance(0.5) ? 0 : width * dice_.between(-0.5, 0.5);
    const std::string drawn = shape(kind, width, top_ + gap, aside, height);
    top_ += gap + height;
    failing_ = yields_ = false;
    particles_ = particles_ || kind == Kind::sph;
    const Real c = material("m" + std::to_string(b));
    std::string line = "  " + name + ": {material: m" + std::to_string(b) + ", shape: " + drawn;
    if (kind == Kind::free_rigid) line += ", rigid: true";
    if (kind == Kind::sph) line += ", method: sph" + particle_options();
    if (kind == Kind::fe && dimensions_ == 3 && draws(0.15)) {
      line += ", element: {type: tet4}";
    } else if (kind == Kind::fe) {
      line += element_options();
    }
    if (kind == Kind::fe && draws(failing_ ? 0.7 : 0.3)) line += erosion();
    line += ", size: " + text(size);
    if (b > 0) {
      const Real speed = dice_.log_between(1, 500);
      fastest_ = std::max(fastest_, speed);
      const Real across = dice_.chance(0.5) ? 0 : speed * dice_.between(-1, 1);
      line += ", velocity: " + vector(across, -speed);
    }
    if (!axisymmetric_ && kind != Kind::floor && dice_.chance(0.15)) {
      line += std::string(", spin: {") + (dimensions_ == 3 ? "axis: z, " : "") +
              "rate: " + text(dice_.between(-500, 500)) +
              ", about: " + vector(0, top_ - 0.5 * height) + "}";
    }
    if (dice_.chance(0.2)) {
      const Real T = dice_.between(250, 700);
      // Without a draw of its own: decks of known seeds stay what they were found for.
      const bool uneven = newer_ && T > 500;
      line += ", temperature: ";
      line += uneven ? "\"= " + text(T) + " + 150 * sin(1000 * x)\"" : text(T);
    }
    if (kind != Kind::free_rigid) {
      shortest_ = std::min(shortest_, size / c);
    }
    if (first_.empty() && kind == Kind::fe) first_ = name;
    return line + "}\n";
  }

  std::string contact() {
    std::string options;
    switch (dice_.one_of(4)) {
      case 0:
        options += ", friction: " + text(dice_.between(0, 0.8));
        break;
      case 1:
        options += ", friction: {static: 0.4, kinetic: 0.2, decay: 0.1}";
        break;
      case 2:
        options += ", friction: 0.3, shear_limit: true";
        break;
      default:
        break;
    }
    if (dice_.chance(0.2)) options += ", damping: " + text(dice_.between(0, 1));
    if (dice_.chance(0.2)) options += ", stiffness: " + text(dice_.log_between(0.1, 1));
    if (dice_.chance(0.3)) {
      options += ", heat: " + dice_.word({"perfect", "{conductance: 1e4}"});
    }
    if (dice_.chance(0.1)) options += ", cohesion: 1e6, tension: 1e6";
    if (dice_.chance(0.1)) options += ", initial_overlap: press";
    if (draws(0.1)) {
      options += ", tied: true";
    } else if (draws(0.1)) {
      options += ", joint: {normal: " + text(more_.log_between(1e10, 1e13)) +
                 (more_.chance(0.5) ? ", max_closure: 1e-4" : "") + "}";
    }
    return options.empty() ? "" : "contact: {default: {" + options.substr(2) + "}}\n";
  }

  std::string boundaries() {
    const std::string axis = dimensions_ == 3 ? "z" : "y";
    std::string all;
    if (!first_.empty() && draws(0.2)) {
      all += "  press: {body: " + first_ + ", where: {side: max-" + axis +
             "}, pressure: " + text(more_.log_between(1e5, 1e8)) + "}\n";
    }
    if (first_.empty() || !dice_.chance(0.35)) return all.empty() ? "" : "boundaries:\n" + all;
    if (first_ == "b0") {
      all += "  foot: {body: b0, where: {side: min-" + axis + "}, fix: [" + axis + "]}\n";
    } else {
      all += "  push: {body: " + first_ + ", where: {side: max-" + axis +
             "}, force: " + vector(0, -dice_.log_between(1, 1e3)) + "}\n";
    }
    return "boundaries:\n" + all;
  }

  Dice dice_, more_;
  bool newer_, failing_ = false, yields_ = false, particles_ = false;
  std::uint64_t seed_;
  int dimensions_ = 3;
  bool axisymmetric_ = false;
  std::string materials_, first_;
  Real top_ = 0;                             // [m] of what stands below
  Real shortest_ = kInfinity, fastest_ = 1;  // [s] a size over its sound; [m/s]
};
}  // namespace

std::string random_deck(std::uint64_t seed, bool newer) { return Writer(seed, newer).deck(); }

}  // namespace brunt::test
