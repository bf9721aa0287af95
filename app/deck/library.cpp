/// The library of materials. Sources and confidence (high, medium, low) stand with each part; a
/// value that is of medium or low confidence, or was not looked up, is to be checked against the
/// original before it decides anything.
#include "app/deck/library.hpp"

#include "io/deck/yaml_reader.hpp"

namespace brunt::deck {

// NOLINTNEXTLINE(readability-function-size): one text, no code.
const char* library_text() {
  return R"yaml(
al-6082-t6:
  summary: aluminium 6082-T6
  sources: ["elastic constants: tables of a public explicit FE program (high)",
    "Johnson-Cook: Frattura ed Integrita Strutturale 48 (2019), table 1 (medium)",
    "thermal: usual values, not looked up (medium)"]
  values:
    density: 2700 kg/m^3
    elastic: {E: 70 GPa, nu: 0.33}
    strength:
      johnson-cook: {A: 428.5 MPa, B: 327.7 MPa, n: 1.008, C: 0.00747, rate_ref: 1 1/s, m: 1.31,
        T_melt: 855 K, T_ref: 293 K}
    thermal: {cp: 900 J/kg/K, k: 170 W/m/K, taylor_quinney: 0.9}
al-6061-t6:
  summary: aluminium 6061-T6
  sources: ["elastic constants: usual values, not looked up (high)",
    "Johnson-Cook: Johnson & Holmquist 1988; Lesuer 2001 (high)",
    "Mie-Gruneisen: Marsh, LASL shock Hugoniot data (high)",
      "thermal: usual values, not looked up (high)"]
  values:
    density: 2703 kg/m^3
    elastic: {E: 68.9 GPa, nu: 0.33}
    strength:
      johnson-cook: {A: 324 MPa, B: 114 MPa, n: 0.42, C: 0.002, rate_ref: 1 1/s, m: 1.34,
        T_melt: 925 K, T_ref: 298 K}
    eos: {mie-gruneisen: {c0: 5240 m/s, s: 1.4, gamma0: 1.97}}
    thermal: {cp: 896 J/kg/K, k: 167 W/m/K, taylor_quinney: 0.9}
al-2024-t351:
  summary: aluminium 2024-T351
  sources: ["elastic constants: usual values, not looked up (high)",
    "Johnson-Cook: Teng & Wierzbicki; Mabrouki et al. (high)",
    "Mie-Gruneisen: usual values, not looked up (high)",
      "thermal: usual values, not looked up (high)"]
  values:
    density: 2785 kg/m^3
    elastic: {E: 73 GPa, nu: 0.33}
    strength:
      johnson-cook: {A: 352 MPa, B: 440 MPa, n: 0.42, C: 0.0083, rate_ref: 1 1/s, m: 1,
        T_melt: 775 K, T_ref: 298 K}
    eos: {mie-gruneisen: {c0: 5328 m/s, s: 1.338, gamma0: 2}}
    thermal: {cp: 875 J/kg/K, k: 121 W/m/K, taylor_quinney: 0.9}
copper-ofhc:
  summary: oxygen-free copper
  sources: ["elastic constants: tables of a public SPH program (high)",
    "Johnson-Cook: Johnson & Cook 1983 (high)", "Mie-Gruneisen: usual values, not looked up (high)",
    "thermal: usual values, not looked up (high)"]
  values:
    density: 8960 kg/m^3
    elastic: {E: 124 GPa, nu: 0.34}
    strength:
      johnson-cook: {A: 90 MPa, B: 292 MPa, n: 0.31, C: 0.025, rate_ref: 1 1/s, m: 1.09,
        T_melt: 1356 K, T_ref: 298 K}
    eos: {mie-gruneisen: {c0: 3940 m/s, s: 1.489, gamma0: 1.99}}
    thermal: {cp: 383 J/kg/K, k: 386 W/m/K, taylor_quinney: 0.9}
armco-iron:
  summary: Armco iron
  sources: ["elastic constants: tables of a public SPH program (high)",
    "Johnson-Cook: Johnson & Cook 1983 (high)",
    "Mie-Gruneisen: usual values, not looked up; fit of the high-pressure phase (medium)",
    "thermal: usual values, not looked up (high)"]
  values:
    density: 7890 kg/m^3
    elastic: {E: 207 GPa, nu: 0.29}
    strength:
      johnson-cook: {A: 175 MPa, B: 380 MPa, n: 0.32, C: 0.06, rate_ref: 1 1/s, m: 0.55,
        T_melt: 1811 K, T_ref: 298 K}
    eos: {mie-gruneisen: {c0: 3574 m/s, s: 1.92, gamma0: 1.69}}
    thermal: {cp: 452 J/kg/K, k: 73 W/m/K, taylor_quinney: 0.9}
steel-4340:
  summary: steel 4340
  sources: ["elastic constants: tables of a public SPH program (high)",
    "Johnson-Cook: Johnson & Cook 1983 (high)",
      "Mie-Gruneisen: usual values, not looked up (medium)",
    "thermal: usual values, not looked up (high)"]
  values:
    density: 7830 kg/m^3
    elastic: {E: 200 GPa, nu: 0.29}
    strength:
      johnson-cook: {A: 792 MPa, B: 510 MPa, n: 0.26, C: 0.014, rate_ref: 1 1/s, m: 1.03,
        T_melt: 1793 K, T_ref: 298 K}
    eos: {mie-gruneisen: {c0: 4569 m/s, s: 1.49, gamma0: 2.17}}
    thermal: {cp: 477 J/kg/K, k: 44.5 W/m/K, taylor_quinney: 0.9}
steel-42crmo4:
  summary: steel 42CrMo4
  sources: ["elastic constants: documentation of DynELA (high)",
    "Johnson-Cook: documentation of DynELA (high)", "thermal: documentation of DynELA (high)"]
  values:
    density: 7830 kg/m^3
    elastic: {E: 206.9 GPa, nu: 0.3}
    strength:
      johnson-cook: {A: 806 MPa, B: 614 MPa, n: 0.168, C: 0.0089, rate_ref: 1 1/s, m: 1.1,
        T_melt: 1813.15 K, T_ref: 293.15 K}
    thermal: {cp: 460 J/kg/K, k: 34 W/m/K, taylor_quinney: 0.9}
steel-1045:
  summary: steel 1045
  sources: ["elastic constants: tables of a public SPH program (high)",
    "Johnson-Cook: tables of a public SPH program (medium)",
    "thermal: tables of a public SPH program (medium)"]
  values:
    density: 7850 kg/m^3
    elastic: {E: 205 GPa, nu: 0.29}
    strength:
      johnson-cook: {A: 615.8 MPa, B: 667.7 MPa, n: 0.255, C: 0.0134, rate_ref: 1 1/s, m: 1.078,
        T_melt: 1623 K, T_ref: 298 K}
    thermal: {cp: 486 J/kg/K, taylor_quinney: 0.9}
ti6al4v:
  summary: titanium Ti6Al4V
  sources: ["elastic constants: tables of a public SPH program (high)",
    "Johnson-Cook: tables of a public SPH program (high)",
      "Mie-Gruneisen: usual values, not looked up (high)",
    "thermal: tables of a public SPH program (high)"]
  values:
    density: 4430 kg/m^3
    elastic: {E: 110 GPa, nu: 0.35}
    strength:
      johnson-cook: {A: 862 MPa, B: 331 MPa, n: 0.34, C: 0.012, rate_ref: 1 1/s, m: 0.8,
        T_melt: 1951 K, T_ref: 298 K}
    eos: {mie-gruneisen: {c0: 5130 m/s, s: 1.028, gamma0: 1.23}}
    thermal: {cp: 526 J/kg/K, k: 6.8 W/m/K, taylor_quinney: 0.9}
tungsten-alloy:
  summary: tungsten alloy 90W
  sources: ["elastic constants: usual values, not looked up (medium)",
    "Johnson-Cook: Johnson & Cook 1983 (high)",
      "Mie-Gruneisen: usual values, not looked up (medium)",
    "thermal: usual values, not looked up (medium)"]
  values:
    density: 17000 kg/m^3
    elastic: {E: 314 GPa, nu: 0.3}
    strength:
      johnson-cook: {A: 1.506 GPa, B: 177 MPa, n: 0.12, C: 0.016, rate_ref: 1 1/s, m: 1,
        T_melt: 1723 K, T_ref: 298 K}
    eos: {mie-gruneisen: {c0: 4029 m/s, s: 1.237, gamma0: 1.54}}
    thermal: {cp: 134 J/kg/K, k: 75 W/m/K, taylor_quinney: 0.9}
tungsten-carbide:
  summary: tungsten carbide with cobalt, elastic
  sources: ["elastic constants: usual values, not looked up (medium)",
    "thermal: tables of a public SPH program (high)"]
  values:
    density: 15250 kg/m^3
    elastic: {E: 600 GPa, nu: 0.22}
    thermal: {cp: 292 J/kg/K, k: 88 W/m/K}
steel:
  summary: steel, elastic
  sources: ["elastic constants: usual values, not looked up (high)",
    "thermal: usual values, not looked up (high)"]
  values:
    density: 7850 kg/m^3
    elastic: {E: 210 GPa, nu: 0.3}
    thermal: {cp: 475 J/kg/K, k: 44.5 W/m/K}
brick:
  summary: brick, elastic
  sources: ["elastic constants: guess (low)"]
  low_confidence: elastic constants
  values:
    density: 1900 kg/m^3
    elastic: {E: 10 GPa, nu: 0.18}
rubber:
  summary: rubber, elastic
  sources: ["elastic constants: tables of a public SPH program (medium)"]
  values:
    density: 1200 kg/m^3
    elastic: {E: 10 MPa, nu: 0.4}
rubber-gray:
  summary: rubber of the rings of Gray, Monaghan & Swift 2001
  sources: ["elastic constants: Gray, Monaghan & Swift 2001 (high)"]
  values:
    density: 1010 kg/m^3
    elastic: {E: 450.8 MPa, nu: 0.39752}
)yaml";
}

Node library() { return read_yaml(library_text(), "library"); }

}  // namespace brunt::deck
