#include "app/deck/measures.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/deck/columns.hpp"
#include "core/fields.hpp"

namespace brunt::deck {

namespace {

bool is_component(std::string_view text, int components) {
  static constexpr std::array<std::string_view, 4> kVector{"x", "y", "z", "magnitude"};
  static constexpr std::array<std::string_view, 6> kTensor{"xx", "yy", "zz", "xy", "yz", "zx"};
  if (components == 3) return std::find(kVector.begin(), kVector.end(), text) != kVector.end();
  return components == 6 && std::find(kTensor.begin(), kTensor.end(), text) != kTensor.end();
}

void describe_field(Schema& s, std::string& body, std::string& field) {
  s.text({"body", "name of a body, or of a piece of one: wall.1.0", Need::required}, body);
  s.text({"field", "a field or a component of one: temperature, stress.xx, velocity.magnitude",
          Need::required},
         field);
  s.require(unit_of_field(field) != nullptr, "field", field_problem(field));
}

void describe_part(Schema& s, std::string& body, std::string& field, WhereInside& where) {
  describe_field(s, body, field);
  s.one_of({"where", "which part, by place at time 0: points, or elements by their centres"},
           where);
}

struct UnitOfKind {
  const char* operator()(const ExtentMeasure&) const { return "m"; }
  const char* operator()(const MinMeasure& m) const { return field(m.field); }
  const char* operator()(const MaxMeasure& m) const { return field(m.field); }
  const char* operator()(const MeanMeasure& m) const { return field(m.field); }
  const char* operator()(const PointMeasure& m) const { return field(m.field); }
  const char* operator()(const HistoryMeasure& m) const {
    return m.reduce == Reduce::integral ? "any" : unit_of_column(m.column);
  }
  const char* operator()(const RestitutionMeasure&) const { return "1"; }
  const char* operator()(const ExpressionMeasure&) const { return "any"; }
  template <class Own>
  const char* operator()(const Own& own) const {
    return own.unit;
  }
  static const char* field(const std::string& name) {
    const char* unit = unit_of_field(name);
    return unit ? unit : "any";
  }
};

}  // namespace

std::string field_problem(const std::string& field) {
  std::string known;
  for (const FieldInfo& info : kFields) {
    known += (known.empty() ? "" : ", ") + std::string(info.name);
    if (info.components == 3) known += ".x|y|z|magnitude";
    if (info.components == 6) known += ".xx|yy|zz|xy|yz|zx";
  }
  return "'" + field + "' is not a number at a point; known are " + known;
}

const char* unit_of_field(const std::string& field) {
  const std::size_t dot = field.find('.');
  const std::string name = field.substr(0, dot);
  for (const FieldInfo& info : kFields) {
    if (name != info.name) continue;
    const bool whole = dot == std::string::npos;
    if (whole ? info.components == 1
              : is_component(std::string_view(field).substr(dot + 1), info.components)) {
      return info.unit;
    }
  }
  return nullptr;
}

const char* unit_of(const Measure& measure) { return std::visit(UnitOfKind{}, measure.kind); }

const char* shown_unit_of(const Measure& measure) {
  const char* unit = unit_of(measure);
  return std::string_view(unit) == "any" ? "" : unit;
}

void describe(Schema& s, ExtentMeasure& measure) {
  s.text({"body", "name of a body, or of a piece of one: wall.1.0", Need::required}, measure.body);
  s.choice({"axis", "axis along which it is measured", Need::required}, measure.axis, s.axes());
}
void describe(Schema& s, MinMeasure& measure) {
  describe_part(s, measure.body, measure.field, measure.where);
}
void describe(Schema& s, MaxMeasure& measure) {
  describe_part(s, measure.body, measure.field, measure.where);
}
void describe(Schema& s, MeanMeasure& measure) {
  describe_part(s, measure.body, measure.field, measure.where);
}

void describe(Schema& s, PointMeasure& measure) {
  describe_field(s, measure.body, measure.field);
  s.list({"at", "a place at time 0", Need::required}, measure.at, {"m"}, Schema::kVector);
}

void describe(Schema& s, HistoryMeasure& measure) {
  static constexpr const char* kReductions[] = {"mean", "max", "min", "last", "integral"};
  s.text({"column", "name of a column of history.csv", Need::required}, measure.column);
  s.choice({"reduce", "how the column becomes a number"}, measure.reduce, kReductions);
  s.real({"from", "first time that counts; default: the start"}, measure.from, {"s", at_least(0)});
  s.real({"to", "last time that counts; default: the end"}, measure.to, {"s", at_least(0)});
  s.require(!measure.from || !measure.to || *measure.from < *measure.to, "to",
            "must be after from");
}

void describe(Schema& s, RestitutionMeasure& measure) {
  s.text({"body", "name of a body, or of a piece of one: wall.1.0", Need::required}, measure.body);
}

void describe(Schema& s, ExpressionMeasure& measure) {
  s.value(measure.formula,
          "an expression over measures above it and parameters, in SI: \"= $a / $b\"");
  s.require(measure.formula.empty() || measure.formula.front() == '=', "",
            "an expression begins with '=': \"= $a / $b\"");
}

void describe(Schema& s, Measure& measure) {
  s.one_of({"", "what is measured", Need::required}, measure.kind);
  s.real({"reference", "the value that it should have"}, measure.reference, {unit_of(measure)});
  s.real({"exact", "the closed form of what the deck models: what sizes are to converge to"},
         measure.exact, {unit_of(measure)});
  s.real({"at", "when: the first step at or after it, 0 before all steps; default: at the end"},
         measure.at, {"s", at_least(0)});
}

}  // namespace brunt::deck
