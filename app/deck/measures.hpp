#pragma once
/// Numbers that a run is asked for, as the deck gives them.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/deck/speed_measure.hpp"
#include "app/deck/where.hpp"
#include "core/schema.hpp"

namespace brunt::deck {

/// Largest minus smallest coordinate of a body's points.
struct ExtentMeasure {
  static constexpr const char* deck_name = "extent";
  static constexpr const char* deck_help = "length of a body along an axis";
  std::string body;
  Axis axis = Axis::x;
};

/// A field over a body, or a part of it at time 0: "temperature", "stress.xx",
/// "velocity.magnitude".
struct MinMeasure {
  static constexpr const char* deck_name = "min";
  static constexpr const char* deck_help = "smallest value of a field in a body";
  std::string body, field;
  WhereInside where;
};
struct MaxMeasure {
  static constexpr const char* deck_name = "max";
  static constexpr const char* deck_help = "largest value of a field in a body";
  std::string body, field;
  WhereInside where;
};
struct MeanMeasure {
  static constexpr const char* deck_name = "mean";
  static constexpr const char* deck_help = "mean by mass (point fields) or volume (cell fields)";
  std::string body, field;
  WhereInside where;
};

/// The field at the place that is `at` at time 0, between points or of the cell that holds it.
struct PointMeasure {
  static constexpr const char* deck_name = "point";
  static constexpr bool reads_start = true;
  static constexpr const char* deck_help =
      "a field at a place of time 0, between the points around it";
  std::string body, field;
  std::vector<Real> at;  ///< [m]
};

enum class Reduce : int { mean, max, min, last, integral };

struct HistoryMeasure {
  static constexpr const char* deck_name = "history";
  static constexpr const char* deck_help = "a column of history.csv, reduced to a number";
  std::string column;
  Reduce reduce = Reduce::last;
  std::optional<Real> from, to;  ///< [s]
};

/// Speed of a body's centre of mass at the end over that at time 0.
struct RestitutionMeasure {
  static constexpr const char* deck_name = "restitution";
  static constexpr const char* reads = "velocity";
  static constexpr bool reads_start = true;
  static constexpr const char* deck_help = "speed of a body's centre after over before";
  std::string body;
};

/// "= $a / $b" over other measures.
struct ExpressionMeasure {
  static constexpr const char* deck_name = "expression";
  static constexpr const char* deck_help = "an expression over other measures: \"= $a / $b\"";
  std::string formula;  ///< as written, with "="; evaluate with io/deck/expression.hpp
};

/// A kind that has `unit` and `value(const MeasureSource&)` needs no more than its name here, and
/// where it reads a field of its `body`, that field's name in `reads`; `reads_start` says that it
/// reads the body as it was at time 0 too.
using MeasureKind =
    std::variant<ExtentMeasure, MinMeasure, MaxMeasure, MeanMeasure, PointMeasure, HistoryMeasure,
                 RestitutionMeasure, ExpressionMeasure, SpeedMeasure>;

struct Measure {
  MeasureKind kind;
  std::optional<Real> reference;  ///< SI, in unit_of(*this)
  std::optional<Real> exact;      ///< SI: the closed form of what the deck models
  std::optional<Real> at;  ///< [s] 0: before the first step, else the first step then or later;
                           ///< none: at the end
};

/// The SI unit of a field such as "stress.xx", or null where no such field exists.
const char* unit_of_field(const std::string& field);
/// What is wrong with a field that is none, and those that are.
std::string field_problem(const std::string& field);
/// The SI unit of a measure's value: "m", "K"; "any" for expressions and unknown columns.
const char* unit_of(const Measure& measure);
/// The same beside a value: nothing where it is not known.
const char* shown_unit_of(const Measure& measure);

void describe(Schema& s, ExtentMeasure& measure);
void describe(Schema& s, MinMeasure& measure);
void describe(Schema& s, MaxMeasure& measure);
void describe(Schema& s, MeanMeasure& measure);
void describe(Schema& s, PointMeasure& measure);
void describe(Schema& s, HistoryMeasure& measure);
void describe(Schema& s, RestitutionMeasure& measure);
void describe(Schema& s, ExpressionMeasure& measure);
void describe(Schema& s, Measure& measure);

}  // namespace brunt::deck
