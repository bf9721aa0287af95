#include <algorithm>
#include <cmath>

#include "app/deck/checks.hpp"
#include "io/number.hpp"

namespace brunt::deck {

namespace {

std::string kelvin(Real temperature) { return short_text(temperature) + " K"; }
std::string exactly(Real temperature) { return rounded(temperature, 9) + " K"; }

/// A material melts once: where `thermal` and laws say it, they agree; what asks for it has it.
void check_melting_point(const Named<Material>& material, Findings& findings) {
  const std::string path = "materials." + material.name;
  const auto& thermal = material.value.thermal;
  const auto* strength = std::get_if<JohnsonCook>(&material.value.strength);
  const auto* damage = std::get_if<JohnsonCookDamage>(&material.value.damage);
  const std::optional<Real> melting = thermal ? thermal->T_melt : std::nullopt;
  const std::optional<Real> flows = strength ? strength->T_melt : std::nullopt;
  if (damage && damage->D5 != 0 && !damage->T_melt && !melting) {
    if (!flows) {
      findings.wrong(path + ".damage.johnson-cook",
                     "needs T_melt where D5 is not 0, here, as that of the strength or as "
                     "thermal.T_melt");
    } else if (!(*flows > damage->T_ref)) {
      findings.wrong(path + ".damage.johnson-cook",
                     "T_ref must be below T_melt = " + kelvin(*flows) + " of the strength");
    }
  }
  if (!melting) return;
  const std::string key = path + ".thermal.T_melt";
  const auto agree = [&](const char* law, const std::optional<Real>& own, Real reference) {
    if (own && *own != *melting) {
      findings.wrong(key, "is " + exactly(*melting) + ", and " + law + ".johnson-cook.T_melt is " +
                              exactly(*own) + ": a material melts once, leave one of them out");
    } else if (!own && !(*melting > reference)) {
      findings.wrong(key, "must be above T_ref = " + kelvin(reference) + " of " + law);
    }
  };
  if (strength) agree("strength", strength->T_melt, strength->T_ref);
  if (damage) agree("damage", damage->T_melt, damage->T_ref);
  if (!strength && !damage) {
    findings.warn(key,
                  "changes nothing: of all laws johnson-cook's alone, of strength or of "
                  "damage, know melting");
  }
}

/// A body that starts at or above the melting of its material has no strength from the start.
void check_melting(const Deck& deck, const Named<Material>& material, Findings& findings) {
  const StrengthLaw strength = material.value.melting_strength();
  const auto* law = std::get_if<JohnsonCook>(&strength);
  if (!law || !law->T_melt) return;
  for (const auto& [name, body] : deck.bodies) {
    const std::string path = "bodies." + name + ".temperature";
    if (body.rigid || body.material != material.name || !findings.sound(path)) continue;
    if (has_temperature_field(body)) continue;  // looked at where it is evaluated
    const Real start = body.temperature ? body.temperature->constant : deck.ambient;
    if (start < *law->T_melt) continue;
    findings.wrong(body.temperature ? path : "ambient",
                   "'" + name + "' starts at " + kelvin(start) + ", and '" + material.name +
                       "' melts at T_melt = " + kelvin(*law->T_melt) +
                       ": it would have no strength; a number without unit is in K, 20 degC is "
                       "293.15 K");
  }
}

/// Metals soften over hundreds of kelvins; over a few, a rounding of the temperature decides.
void check_softening(const Named<Material>& material, Findings& findings) {
  constexpr Real kNarrow = 50;  // [K]
  const auto look = [&](const std::string& key, Real reference, Real melting) {
    const std::string at = "materials." + material.name;
    const std::string path = findings.stands(at + key + ".T_melt") ? at + key : at + ".thermal";
    if (!findings.sound(path) || melting <= reference) return;
    if (melting - reference >= kNarrow) return;
    findings.warn(path + ".T_melt",
                  "heat acts in full within the " + kelvin(melting - reference) +
                      " from T_ref = " + kelvin(reference) + " to T_melt = " + kelvin(melting) +
                      "; in metals that takes hundreds of kelvins: check both, and their units");
  };
  const StrengthLaw strength = material.value.melting_strength();
  const DamageChoice damage = material.value.melting_damage();
  if (const auto* law = std::get_if<JohnsonCook>(&strength); law && law->T_melt) {
    look(".strength.johnson-cook", law->T_ref, *law->T_melt);
  }
  if (const auto* law = std::get_if<JohnsonCookDamage>(&damage); law && law->T_melt) {
    if (law->D5 != 0) look(".damage.johnson-cook", law->T_ref, *law->T_melt);
  }
}

void check_heat(const Deck& deck, const Named<Material>& material, Findings& findings) {
  const auto* law = std::get_if<JohnsonCook>(&material.value.strength);
  const bool softens = law && law->T_melt;
  const bool deforms = std::any_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& body) {
    return body.value.material == material.name && !body.value.rigid;
  });
  if (deck.heat == Heat::automatic && softens && deforms && !material.value.thermal) {
    findings.warn("materials." + material.name + ".strength",
                  "softens with heat (T_melt), and without `thermal: {cp: ...}` nothing heats it; "
                  "heat: off says that this is meant");
  }
}

/// s of a solid is 1 to 2; the pressure of the Hugoniot is infinite at a compression of 1/s.
void check_equation_of_state(const Named<Material>& material, Findings& findings) {
  const auto* eos = std::get_if<MieGruneisen>(&material.value.eos);
  const std::string path = "materials." + material.name + ".eos.mie-gruneisen";
  if (!eos || !findings.sound("materials." + material.name)) return;
  constexpr Real kSingular = 0.05;
  if (eos->s * kSingular > 1) {
    findings.wrong(path + ".s", "the pressure becomes infinite at a compression of 1/s = " +
                                    short_text(100 / eos->s) +
                                    " %; s is 1 to 2 for solids, such as 1.49 for copper");
  }
  const Real from_shock = material.value.density * eos->c0 * eos->c0;
  const Real from_elastic = material.value.bulk_modulus();
  constexpr Real kFar = 2;
  if (from_shock > kFar * from_elastic || from_elastic > kFar * from_shock) {
    findings.warn(path + ".c0", "density c0^2 = " + short_text(from_shock / 1e9) +
                                    " GPa is the bulk modulus that is used, and `elastic` gives " +
                                    short_text(from_elastic / 1e9) + " GPa: check both");
  }
}

void check_expansion(const Deck& deck, const Named<Material>& material, Findings& findings) {
  const auto& thermal = material.value.thermal;
  const std::string path = "materials." + material.name;
  if (!thermal || thermal->expansion == 0 || !findings.sound(path)) return;
  if (make_eos(material.value.eos, {material.value.density, 0})->needs_energy()) {
    findings.wrong(path + ".thermal.expansion",
                   "is not for this equation of state, which expands by its own energy: leave it "
                   "out, or take the linear one");
  }
  if (deck.heat == Heat::off) {
    findings.warn(path + ".thermal.expansion",
                  "nothing is heated with heat: off, and so nothing expands");
  }
}

/// Damage counts plastic strain, or is refused where another law lets the point open.
void check_damage(const Named<Material>& material, Findings& findings) {
  const auto& law = material.value.damage;
  const std::string path = "materials." + material.name + ".damage";
  if (std::holds_alternative<NoDamage>(law)) return;
  const bool counts_strain = std::holds_alternative<JohnsonCookDamage>(law) ||
                             std::holds_alternative<StrainDamage>(law) ||
                             std::holds_alternative<CockcroftLatham>(law);
  if (counts_strain && std::holds_alternative<NoStrength>(material.value.strength)) {
    findings.wrong(path,
                   "counts plastic strain, and without `strength` there is none: add one, or "
                   "write damage: {principal_stress: ...} or {mean_tension: ...}");
  }
  if (std::holds_alternative<DruckerPrager>(material.value.strength)) {
    findings.wrong(path,
                   "drucker-prager has a tension limit of its own: leave `damage` out, or "
                   "write tensile_cutoff");
  }
  const auto* ductile = std::get_if<JohnsonCookDamage>(&law);
  if (ductile && ductile->D1 + ductile->D2 * std::exp(ductile->D3 / 3) <= 0) {
    findings.wrong(path + ".johnson-cook",
                   "fails at the first plastic strain of a bar that is pulled: "
                   "D1 + D2 exp(D3/3) must be above 0");
  }
  const auto* spall = std::get_if<MeanTensionDamage>(&law);
  const auto& cutoff = material.value.tensile_cutoff;
  if (spall && cutoff && spall->strength > *cutoff) {
    findings.wrong(path, "is never reached: tensile_cutoff allows no tension beyond " +
                             short_text(*cutoff / 1e6) + " MPa; leave it out");
  }
}

/// An element that fails holds f^2/2E per volume then: in a long one that is more than its crack
/// may take, and it fails in one step (M22).
void check_crack(const Deck& deck, const Named<Material>& material, Findings& findings) {
  const Real K = material.value.bulk_modulus(), G = material.value.shear_modulus();
  Real energy = 0, held = 0;  // [J/m^2], [J/m^3]
  if (const auto* law = std::get_if<PrincipalStressDamage>(&material.value.damage)) {
    energy = law->energy, held = law->strength * law->strength * (3 * K + G) / (18 * K * G);
  } else if (const auto* spall = std::get_if<MeanTensionDamage>(&material.value.damage)) {
    energy = spall->energy, held = spall->strength * spall->strength / (2 * K);
  }
  if (!(energy > 0) || !(held > 0 && held < kInfinity)) return;
  for (const auto& [name, body] : deck.bodies) {
    if (body.rigid || body.material != material.name || !body.size || body.size->empty()) continue;
    const Real longest = *std::max_element(body.size->begin(), body.size->end());
    if (longest * held <= energy) continue;
    findings.warn("materials." + material.name + ".damage.energy",
                  "a crack through '" + name + "' takes " + short_text(longest * held) +
                      " J/m^2: an element of " + length_text(longest) +
                      " holds as much when it fails; that energy takes elements below " +
                      length_text(energy / held));
    return;
  }
}

/// Springs of contact are as stiff as the body, and hold no pressure of that size.
void check_start_pressure(const Deck& deck, const Named<Material>& material, Findings& findings) {
  const std::string path = "materials." + material.name;
  if (deck.bodies.size() < 2 || !findings.sound(path)) return;
  const auto eos = make_eos(material.value.eos, {material.value.density, 0});
  const Real share = eos->initial_pressure() / eos->bulk_modulus();
  constexpr Real kSmall = 0.05;
  if (!(share > kSmall)) return;
  findings.warn(path + ".eos",
                "starts at a pressure of " + short_text(100 * share) +
                    " % of its stiffness: contact cannot hold that, faces would overlap by as much "
                    "of an element; hold them by boundaries");
}

/// c = sqrt((K + 4/3 G) / rho) [m/s] of all that is solid is 50 to 20,000; beyond, a unit is wrong.
void check_sound_speed(const Named<Material>& material, Findings& findings) {
  const std::string path = "materials." + material.name;
  const auto reported = [&](const char* key) { return findings.warned(path + key); };
  if (reported(".density") || reported(".elastic")) return;  // of the same value
  constexpr Range kUsual{50, 20'000}, kSolid{300, 13'000};
  if (!material.value.elastic) return;  // of fluids: laws bound their own sound speeds
  const ElasticConstants& elastic = *material.value.elastic;
  const Real modulus = elastic.bulk_modulus() + 4.0 / 3 * elastic.shear_modulus();
  const Real density = material.value.density;
  const auto speed = [&](Real stiffer, Real denser) {
    return std::sqrt(stiffer * modulus / (denser * density));
  };
  const Real c = speed(1, 1);
  if (c >= kUsual.min && c <= kUsual.max) return;
  const auto is_solid = [&](Real one) { return one >= kSolid.min && one <= kSolid.max; };
  const char* modulus_key = elastic.E ? "E" : "K";
  const Real given = elastic.E ? *elastic.E : *elastic.K;
  const char* key = ".elastic";
  std::string meant = "check density and elastic constants, and their units";
  if (density < 30 && is_solid(speed(1, 1e3))) {
    key = ".density";
    meant = "density: " + short_text(density) + " g/cm^3, " + short_text(1e3 * density) +
            " kg/m^3, was probably meant";
  } else if (c < kUsual.min) {
    for (const Real factor : {1e9, 1e6, 1e3}) {
      if (!is_solid(speed(factor, 1))) continue;
      meant = std::string(modulus_key) + ": " + short_text(factor * given / 1e9) +
              " GPa was probably meant";
      break;
    }
  }
  findings.warn(path + key, "sound would travel in it at " + short_text(c) +
                                " m/s, and in solids at 50 to 20,000: " + meant);
}

}  // namespace

void check_materials(const Deck& deck, Findings& findings) {
  for (const auto& material : deck.materials) {
    if (!findings.sound("materials." + material.name)) continue;
    check_melting_point(material, findings);
    check_melting(deck, material, findings);
    check_softening(material, findings);
    check_heat(deck, material, findings);
    check_equation_of_state(material, findings);
    check_expansion(deck, material, findings);
    check_damage(material, findings);
    check_crack(deck, material, findings);
    check_sound_speed(material, findings);
    check_start_pressure(deck, material, findings);
  }
  const auto conducts = [](const auto& material) {
    return material.value.thermal && material.value.thermal->k;
  };
  if (deck.heat == Heat::conduct && findings.sound("materials") &&
      std::none_of(deck.materials.begin(), deck.materials.end(), conducts)) {
    findings.wrong("heat",
                   "no material conducts: add `thermal: {cp: ..., k: ...}` to one, or write auto");
  }
  const auto heated = [](const auto& material) { return material.value.heats_itself(); };
  if (deck.heat == Heat::adiabatic && findings.sound("materials") &&
      std::none_of(deck.materials.begin(), deck.materials.end(), heated)) {
    findings.wrong(
        "heat",
        "no material can be heated: that takes `thermal: {cp: ...}`, and `strength` or an "
        "`eos` with an energy, such as mie-gruneisen; add them to a material, or write "
        "heat: off");
  }
}

}  // namespace brunt::deck
