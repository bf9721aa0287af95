// The deck that is stepped against the deck as written, value by value, and results made real
// again. A speed of 4 divides and multiplies without rounding.
#include "app/deck/process_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "app/deck/columns.hpp"
#include "app/watch/real_values.hpp"
#include "core/fields.hpp"
#include "full_deck.hpp"

namespace brunt {
namespace {

using deck::kFull;
using deck::time_power;

/// The full deck without what has no process speed, at four times its speed.
LoadedDeck fast(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.end(),
                   {"time.process_speed=4", "materials.jw=null", "measures.m_restitution=null"});
  return load_deck_text(kFull, "full.yaml", overrides);
}

Deck slow() {
  return load_deck_text(kFull, "full.yaml", {"materials.jw=null", "measures.m_restitution=null"})
      .deck;
}

template <class T>
const T& named(const std::vector<Named<T>>& entries, const std::string& name) {
  for (const auto& entry : entries) {
    if (entry.name == name) return entry.value;
  }
  throw std::invalid_argument(name);
}

std::string problems_of(const std::vector<std::string>& overrides) {
  try {
    load_deck_text(kFull, "full.yaml", overrides);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

TEST(TimePower, CountsSecondsBesideForcesAndEnergies) {
  const std::pair<const char*, int> known[] = {
      {"s", 1},  {"m/s", -1},   {"m/s^2", -2}, {"rad/s", -1},   {"1/s", -1},    {"s/m", 1},
      {"W", -1}, {"W/m/K", -1}, {"W/m^2", -1}, {"W/m^2/K", -1}, {"kg m/s", -1}, {"Pa s", 1},
      {"Pa", 0}, {"J/kg/K", 0}, {"kg/m^3", 0}, {"N m", 0},      {"any", 0},     {"1", 0}};
  for (const auto& [unit, power] : known) EXPECT_EQ(time_power(unit), power) << unit;
  EXPECT_THROW(time_power("V"), std::logic_error);
}

TEST(TimePower, KnowsTheUnitOfEveryColumnAndField) {
  for (const auto& column : deck::kHistoryColumns) EXPECT_NO_THROW(time_power(column.unit));
  for (const auto& field : kFields) EXPECT_NO_THROW(time_power(field.unit));
}

TEST(ProcessSpeed, OneOrNoneChangesNothing) {
  const auto given = load_deck_text(kFull, "full.yaml");
  const auto one = load_deck_text(kFull, "full.yaml", {"time.process_speed=1"});
  EXPECT_EQ(echo(given.deck), given.resolved);
  EXPECT_EQ(one.resolved, given.resolved);
  EXPECT_EQ(one.hash, given.hash);
}

TEST(ProcessSpeed, TheResolvedDeckIsTheUsers) {
  const auto given = fast();
  Deck real = slow();
  real.time.process_speed = 4;
  EXPECT_EQ(given.resolved, echo(real));
  EXPECT_EQ(load_deck_text(given.resolved, "resolved.yaml").resolved, given.resolved);
}

TEST(ProcessSpeed, TimesAreDivided) {
  const Deck now = fast().deck, was = slow();
  EXPECT_EQ(now.time.end, was.time.end / 4);
  EXPECT_EQ(*now.time.max_step, *was.time.max_step / 4);
  EXPECT_EQ(*now.time.min_step, *was.time.min_step / 4);
  EXPECT_EQ(*now.time.until, *was.time.until / 4);
  EXPECT_EQ(now.time.mass_scaling->step, was.time.mass_scaling->step / 4);
  EXPECT_EQ(now.time.mass_scaling->max_added_mass, was.time.mass_scaling->max_added_mass);
  EXPECT_EQ(now.time.real(now.time.end), was.time.end);
  EXPECT_EQ(*now.output.every, *was.output.every / 4);
  EXPECT_EQ(*now.output.history, *was.output.history / 4);
  EXPECT_EQ(*now.output.from, *was.output.from / 4);
  EXPECT_EQ(*now.output.to, *was.output.to / 4);
  EXPECT_EQ(now.output.checkpoint, was.output.checkpoint);  // wall time
  EXPECT_EQ(now.stop.at_rest->duration, was.stop.at_rest->duration / 4);
  EXPECT_EQ(named(now.boundaries, "surface").from, named(was.boundaries, "surface").from / 4);
  EXPECT_EQ(named(now.boundaries, "surface").to, named(was.boundaries, "surface").to / 4);
  EXPECT_EQ(named(now.boundaries, "all").to, kInfinity);
  EXPECT_EQ(now.damping->until, was.damping->until / 4);
  EXPECT_EQ(*named(now.bodies, "l").element.erosion->when.step,
            *named(was.bodies, "l").element.erosion->when.step / 4);
}

TEST(ProcessSpeed, SpeedsAndRatesAreMultiplied) {
  const Deck now = fast().deck, was = slow();
  EXPECT_EQ(named(now.bodies, "a").velocity, (std::vector<Real>{4, 8, 12}));
  EXPECT_EQ(named(now.bodies, "a").spin->rate, 12);
  EXPECT_EQ(named(now.bodies, "e").motion->velocity, (std::vector<Real>{0, 0, 4}));
  EXPECT_EQ(named(now.bodies, "e").motion->spin->rate,
            4 * named(was.bodies, "e").motion->spin->rate);
  EXPECT_EQ(now.stop.at_rest->below, 4);
  EXPECT_EQ(now.damping->rate, 400);
  EXPECT_EQ(deck::gravity_at(now.gravity, 0), (std::array<Real, 3>{0, 0, -9.81}));
}

TEST(ProcessSpeed, HeatFlowsFaster) {
  const Deck now = fast().deck, was = slow();
  EXPECT_EQ(named(now.materials, "jc").thermal->k->constant, 4 * 386);
  EXPECT_EQ(named(now.materials, "jc").thermal->cp->constant, 383);
  const auto heat = [](const Deck& deck) {
    return named(deck.boundaries, "warm").of<SurfaceHeat>();
  };
  EXPECT_EQ(heat(now).flux->constant, 4000);
  EXPECT_EQ(heat(now).convection->h->constant, 40);
  EXPECT_EQ(heat(now).convection->T->constant, 300);
  EXPECT_EQ(heat(now).radiation->emissivity, 4 * heat(was).radiation->emissivity);
  EXPECT_EQ(named(now.boundaries, "side").of<FollowerPressure>().pressure->constant, 1000);
  const auto& fallback = std::get<ContactConductance>(now.contact.fallback.heat);
  EXPECT_EQ(fallback.per_area->constant, 4e4);
}

TEST(ProcessSpeed, FrictionSlidesAtRealSpeeds) {
  const Deck now = fast().deck;
  EXPECT_EQ(now.contact.fallback.coulomb.decaying->decay, 0.5);  // s/m of 2
  const auto friction = [&](const char* pair) {
    return *named(now.contact.pairs, pair).options.coulomb.friction;
  };
  EXPECT_EQ(friction("ab").abscissa, (std::vector<Real>{0, 4}));
  EXPECT_EQ(friction("ab").ordinate, (std::vector<Real>{0.3, 0.2}));
  // 0.3 - v/1000 - T/1e5 at v = 20 m/s, of which the scene sees 80.
  EXPECT_DOUBLE_EQ(friction("ag").evaluate({300, 0, 0, 80}), 0.3 - 0.02 - 0.003);
}

TEST(ProcessSpeed, TablesAndExpressionsAreOfRealTime) {
  const Deck now =
      fast({"boundaries.plane.force.0={table: [[0, 0], [1 ms, 3 kN]], over: time}"}).deck;
  const auto& force = *named(now.boundaries, "plane").of<AppliedForce>().force->front();
  EXPECT_EQ(force.abscissa, (std::vector<Real>{0, 0.25e-3}));
  EXPECT_EQ(force.ordinate, (std::vector<Real>{0, 3000}));
  const auto& velocity = *named(now.boundaries, "surface").of<PrescribedMotion>().velocity;
  EXPECT_EQ(velocity[2]->evaluate({2, 0, 0, 0}), 4 * 8);  // "= t", 8 s of the process
}

TEST(ProcessSpeed, StrengthIsThatOfTheRealRate) {
  const Deck now = fast({"materials.jc.strength.johnson-cook.C=0.05"}).deck;
  const Deck was =
      load_deck_text(kFull, "full.yaml",
                     {"materials.jc.strength.johnson-cook.C=0.05", "materials.jw=null"})
          .deck;
  for (const Real rate : {1e-5, 0.5, 30.0, 1e4}) {
    const auto jc = [&](const Deck& deck, Real at) {
      return std::get<JohnsonCook>(named(deck.materials, "jc").strength)
          .flow_stress(0.3, at, 400.0);
    };
    EXPECT_EQ(jc(now, 4 * rate), jc(was, rate));
    const auto za = [&](const Deck& deck, Real at) {
      return std::get<ZerilliArmstrong>(named(deck.materials, "za").strength)
          .flow_stress(0.3, at, 400.0);
    };
    // C3 T of 2.8 and C4 T ln(rate) of 2: their rounding, in an exponent.
    EXPECT_NEAR(za(now, 4 * rate) / za(was, rate), 1, 1e-14);
    const auto hjc = [&](const Deck& deck, Real at) {
      return std::get<Holmquist>(named(deck.materials, "hj").strength).strength(1e7, 0.2, at);
    };
    EXPECT_EQ(hjc(now, 4 * rate), hjc(was, rate));
    const auto damage = [&](const Deck& deck, Real at) {
      const DamagePoint<Real> point{0.1, 0.01, at, 400, -1e8, 3e8, 0};
      return std::get<JohnsonCookDamage>(named(deck.materials, "d1").damage).strain_to_fail(point);
    };
    EXPECT_EQ(damage(now, 4 * rate), damage(was, rate));
  }
}

TEST(ProcessSpeed, SoundSpeedsAreStiffness) {
  const Deck now = fast().deck;
  EXPECT_EQ(std::get<MieGruneisen>(named(now.materials, "jc").eos).c0, 3940);
  EXPECT_EQ(std::get<Tait>(named(now.materials, "ta").eos).c0, 1480);
}

TEST(ProcessSpeed, MeasuresAreReal) {
  const Deck now = fast({"measures.m_speed.reference=3 m/s"}).deck, was = slow();
  EXPECT_EQ(*named(now.measures, "m_extent").at, *named(was.measures, "m_extent").at / 4);
  EXPECT_EQ(*named(now.measures, "m_speed").reference, 3);
  const auto& history = std::get<deck::HistoryMeasure>(named(now.measures, "m_history").kind);
  EXPECT_EQ(*history.from, 1e-6);
  EXPECT_EQ(*history.to, 2e-6);
}

TEST(ProcessSpeed, WhatInertiaDecidesIsRefusedOrWarnedOf) {
  const std::string wrong = problems_of({"time.process_speed=4"});
  EXPECT_NE(wrong.find("materials.jw.eos: an explosive drives itself"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("measures.m_restitution.restitution: a rebound"), std::string::npos);
  EXPECT_EQ(problems_of({"time.process_speed=1"}), "");
  EXPECT_NE(problems_of({"time.process_speed=0.5"}).find("time.process_speed: "),
            std::string::npos);
  std::string warned;
  for (const auto& warning : fast().warnings) warned += warning.text() + "\n";
  EXPECT_NE(warned.find("gravity: acts with its own force"), std::string::npos) << warned;
  EXPECT_NE(warned.find("boundaries.side.nonreflecting: resists"), std::string::npos);
}

TEST(RealValues, RowsAndViewsGoByTheirUnits) {
  RealValues real(4);
  real.set_columns({"time", "step", "energy.kinetic", "momentum.x", "body.a.velocity.x",
                    "body.a.force.x", "contact.a-b.heat_rate", "probe.p.acceleration.y",
                    "probe.p.stress.xx", "state_hash"});
  std::vector<Real> row = {1, 3, 16, 8, 8, 5, 8, 32, 7};
  real.make_real(row);
  EXPECT_EQ(row, (std::vector<Real>{4, 3, 16, 2, 2, 5, 2, 2, 7}));
  BodyView view;
  view.time = 2, view.position = {1, 1, 1};
  view.point_fields = {{"velocity", 3, {4, 8, 12}}, {"temperature", 1, {300}}};
  view.cell_fields = {{"strain_rate", 1, {8}}, {"stress", 6, {1, 2, 3, 4, 5, 6}}};
  real.make_real(view);
  EXPECT_EQ(view.time, 8);
  EXPECT_EQ(view.position, (std::vector<Real>{1, 1, 1}));
  EXPECT_EQ(view.point_fields[0].values, (std::vector<Real>{1, 2, 3}));
  EXPECT_EQ(view.point_fields[1].values, (std::vector<Real>{300}));
  EXPECT_EQ(view.cell_fields[0].values, (std::vector<Real>{2}));
  EXPECT_EQ(view.cell_fields[1].values, (std::vector<Real>{1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace brunt
