#pragma once
/// Decks that hold every key of a deck once, for tests of all keys. A new key goes in here.

namespace brunt::deck {

inline const char* const kFull = R"yaml(
title: all keys in 3D
quality: careful
time: {end: 1 ms, max_step: 1 us, min_step: 1 ps, heat_every: 4, until: 0.5 ms, process_speed: 1,
  mass_scaling: {step: 1 ns, max_added_mass: 5 %}}
materials:
  jc:
    density: 8960
    elastic: {E: 124 GPa, nu: 0.34}
    strength: {johnson-cook: {A: 90 MPa, B: 292 MPa, n: 0.31, T_melt: 1356 K}}
    eos: {mie-gruneisen: {c0: 3940, s: 1.49, gamma0: 1.96}}
    tensile_cutoff: 1 GPa
    thermal: {T_melt: 1356 K, cp: 383, k: 386}
  j2:
    {density: 2700, elastic: {K: 70 GPa, G: 26 GPa},
     strength: {j2: {yield: 300 MPa, hardening: {table: [[0, 0], [1, 1 MPa]], over: eps_p}}}}
  za:
    {density: 7870, elastic: {E: 207 GPa, nu: 0.29}, strength: {zerilli-armstrong:
      {C0: 9 MPa, C1: 1 GPa, C2: 1 MPa, C3: 0.007, C4: 4e-4, C5: 266 MPa, n: 0.3}}}
  dp:
    {density: 2000, elastic: {K: 1 GPa, G: 0.5 GPa}, strength: {drucker-prager:
      {cohesion: 1 MPa, friction_angle: 30 deg, dilation_angle: 9 deg}}}
  sg: {density: 8930, elastic: {K: 137 GPa, G: 47 GPa}, strength: {steinberg-guinan:
      {Y0: 120 MPa, Y_max: 640 MPa, beta: 36, n: 0.45, A: 28e-12, B: 3.8e-4}}}
  ta: {density: 1000, eos: {tait: {c0: 1480}}}
  tb: {density: 1000, eos: {tait: {B: 304.7 MPa}}}
  ig: {density: 1.2, eos: {ideal-gas: {pressure: 1e5}}}
  po: {density: 1000, elastic: {K: 2 GPa, G: 0}, eos: {polynomial: {C1: 2e9}}}
  d1: {density: 8930, elastic: {K: 137 GPa, G: 47 GPa}, strength: {j2: {yield: 1 MPa}},
       damage: {johnson-cook: {D1: 0.1, D2: 1, D3: -2, D4: 0.01, D5: 0.1, rate: 1, T_ref: 298,
                T_melt: 1356, energy: 1}}}
  d2: {density: 8930, elastic: {K: 137 GPa, G: 47 GPa}, strength: {j2: {yield: 1 MPa}},
       damage: {strain: 0.5, energy: 1}}
  d3: {density: 8930, elastic: {K: 137 GPa, G: 47 GPa}, strength: {j2: {yield: 1 MPa}},
       damage: {cockcroft_latham: 1e8, energy: 1}}
  d4: {density: 2500, elastic: {K: 37 GPa, G: 27 GPa}, damage: {principal_stress: 1e8, energy: 1}}
  d5: {density: 2500, elastic: {K: 37 GPa, G: 27 GPa}, damage: {mean_tension: 1e8, energy: 1}}
  cc: {density: 2440, strength: {concrete-cap: {fc: 30e6, ft: 2e6, Gf: 100, K: 16e9, K_solid: 45e9,
       G: 13e9, phi0: 0.1, p_crush: 30e6, p_lock: 1e9, cap_start: 0.7, a0: 9e6, a1: 0.4, a2: 1e-9,
       b1: 0.4, b2: 1e-9, dilatancy: 0.5, phi_damage: 0.002}}}
  hj: {density: 2440, strength: {hjc: {fc: 48e6, G: 15e9, A: 0.79, B: 1.6, N: 0.61, C: 0.007,
       rate_ref: 1, S_max: 7, T: 4e6, D1: 0.04, D2: 1, ef_min: 0.01, p_crush: 16e6, mu_crush: 0.001,
       p_lock: 8e8, mu_lock: 0.1, locking: at-pressure, K1: 85e9, K2: -171e9, K3: 208e9}}}
  jw: {density: 1630, eos: {jwl: {A: 371e9, B: 3.2e9, R1: 4, R2: 0.9, omega: 0.3, E0: 7e9}}}
symmetry: {x: -1, y: -1, z: -1}
bodies:
  a:
    material: jc
    shape: {box: {min: [0, 0, 0], max: [1, 1, 1]}, translate: [1, 1, 1]}
    size: 0.1
    grading: {axis: z, ratio: 5, toward: both}
    velocity: [1, 2, 3]
    spin: {axis: x, rate: 3 rad/s, about: [0, 0, 0]}
    stress: {xx: -1e6, yy: "= -2e4 * z", zz: -1e6, xy: 1e5, yz: 1e5, zx: 1e5}
    temperature: "= 300 + 0.5 * z"
    element: {hourglass: {viscous: 0.1}}
  b:
    material: j2
    shape: {cylinder: {radius: 1, length: 2, base: [3, 3, 3], axis: z}}
    cells: [4, 4, 8]
    element: {hourglass: {stiffness: 0.05}}
  c:
    material: j2
    shape: {tube: {inner: 1, outer: 2, length: 2, base: [9, 3, 3], axis: x}}
    cells: [4, 4, 8]
    element: {hourglass: {assumed_strain: 1}}
  d:
    method: sph
    material: jc
    shape:
      sphere: {radius: 1, center: [5, 5, 5]}
      rotate: {axis: y, angle: 10 deg, about: [0, 0, 0]}
    size: 0.1
  ct:
    rigid: true
    shape: {wedge: {tip: [40, 0, 0], rake: 6 deg, clearance: 8 deg, edge_radius: 0.1 mm,
                    height: 1, length: 1, thickness: 1}}
  e:
    rigid: true
    shape: {polygon: {points: [[0, 0], [1, 0], [0, 1]], thickness: 1}}
    motion:
      velocity: [0, {table: [[0, 0], [1, 1]], over: time}, 1]
      spin: {axis: z, rate: 1 rpm, about: [0, 0, 0]}
      temperature: 300
  f: {rigid: true, shape: {plane: {origin: [0, 0, -9], normal: z, extent: 4}}}
  g:
    material: dp
    shape: {brick-wall: {bricks: [4, 1, 3], brick: [0.2, 0.1, 0.1], origin: [0, 20, 0]}}
    size: 0.05
  h:
    method: sph
    material: sg
    shape: {ogive: {radius: 1, length: 4, nose: 2, base: [0, -20, 0]}}
    size: 0.1
  j:
    rigid: true
    file: part.stl
    scale: 1 mm
    rotate: {axis: y, angle: 10 deg, about: [0, 0, 0]}
    translate: [30, 0, 0]
  k:
    {method: sph, material: ta, file: part.msh, part: plate, size: 0.1, formulation: total,
     hourglass: 30}
  i:
    material: za
    shape:
      polygon: {points: [[0, 0], [1, 0], [1, 1], [0, 1]], thickness: 1, corners: [0, 1, 2, 3]}
    size: 0.1
  l:
    material: d2
    shape: {box: {min: [40, 0, 0], max: [41, 1, 1]}}
    size: 0.5
    erode: {when: [damage, strain: 1.5, step: 1 ns, inverted], to: nothing}
contact:
  default:
    friction: {static: 0.3, kinetic: 0.2, decay: 2 s/m}
    heat: {conductance: 1e4 W/m^2/K, gap: 1 mm}
    friction_heat: {fraction: 0.5, split: 0.3}
  pairs:
    ab:
      between: [a, b]
      friction: {table: [[0, 0.3], [1 m/s, 0.2]], over: slip_speed}
      heat: {conductance: 2e4 W/m^2/K}
    ac: {between: [a, c], friction: {static: 0.4, kinetic: 0.4, decay: 0}}
    ag: {between: [a, g], friction: "= 0.3 - v/1000 - T/1e5", shear_limit: true}
    ad: {between: [a, d], friction: 0.3, cohesion: 1 MPa, tension: 0.5 MPa,
         initial_overlap: press, plane: point}
    dd: {between: [d, d], bonded: true, resting_layer: 5}
    ae: {between: [a, e], tied: true,
         joint: {normal: 3.5 GPa/m, shear: 1 GPa/m, max_closure: 0.5 mm}}
    be: {between: [b, e], joint: {normal: 3.5 GPa/m, exponential_closure: 0.5 mm}}
boundaries:
  all: {body: a, where: all, fix: [x]}
  surface: {body: a, where: surface, velocity: [0, free, "= t"], from: 1 us, to: 2 us}
  plane: {body: a, where: {plane: {axis: x, at: 1}}, force: [0, 0, 1]}
  box: {body: a, where: {box: {min: [0, 0, 0], max: [1, 1, 1]}}, fix: [x]}
  bolt: {body: a, where: {cylinder: {radius: 1, length: 1, base: [0, 0, 0], axis: z}}, fix: [x]}
  side: {body: a, where: {side: min-x}, fix: [x], pressure: 1000, nonreflecting: true}
  set: {body: k, where: {set: foot}, fix: [x]}
  hot: {body: a, where: {side: max-x}, temperature: 400}
  warm: {body: a, where: {side: min-x}, flux: 1000, convection: {h: 10, T: 300},
         radiation: {emissivity: 0.8, T: 300}}
probes: {tip: {body: a, at: [0, 0, 0], fields: [temperature, stress.xx]}}
sections: {neck: {body: a, plane: {axis: x, at: 1.5}}}
gravity: [0, 0, -9.81]
damping: {rate: 100, until: 1 ms}
measures:
  m_extent: {extent: {body: a, axis: x}, reference: 1, exact: 1, at: 1 us}
  m_min: {min: {body: a, field: pressure, where: all}}
  m_min_box: {min: {body: a, field: pressure, where: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}}
  m_min_hole:
    min:
      {body: a, field: pressure,
       where: {cylinder: {radius: 1, length: 1, base: [0, 0, 0], axis: z}}}
  m_max: {max: {body: a, field: stress.xx, where: all}}
  m_max_box: {max: {body: a, field: stress.xx, where: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}}
  m_max_hole:
    max:
      {body: a, field: stress.xx,
       where: {cylinder: {radius: 1, length: 1, base: [0, 0, 0], axis: z}}}
  m_mean: {mean: {body: a, field: velocity.x, where: all}}
  m_mean_box: {mean: {body: a, field: velocity.x, where: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}}
  m_mean_hole:
    mean:
      {body: a, field: velocity.x,
       where: {cylinder: {radius: 1, length: 1, base: [0, 0, 0], axis: z}}}
  m_point: {point: {body: a, field: temperature, at: [0, 0, 0]}}
  m_history: {history: {column: energy.total, from: 1 us, to: 2 us}}
  m_restitution: {restitution: {body: a}}
  m_speed: {speed: {body: a}}
  m_expression: {expression: "= $m_min / $m_max"}
stop:
  at_rest: {body: a, below: 1, for: 1 us}
  beyond: {body: a, axis: z, at: 3}
  when: "= time > 1"
output:
  {every: 1 us, history: 1 us, state_hash: true, from: 1 us, to: 2 us, fields: [stress],
   bodies: [a]}
)yaml";

inline const char* const kFlat = R"yaml(
geometry: plane-strain
depth: 10 mm
time: {end: 1 ms}
materials: {m: {density: 1000, elastic: {K: 1 GPa, G: 1 GPa}}}
bodies: {b: {material: m, cells: [4, 4], shape: {box: {min: [0, 0], max: [1, 1]}}}}
)yaml";

}  // namespace brunt::deck
