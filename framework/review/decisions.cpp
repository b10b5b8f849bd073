#include "review/decisions.hpp"

#include <cmath>

namespace opal {
namespace {

/// So that a document has the numbers that were compared.
double rounded(double value) { return std::round(1000 * value) / 1000; }
Point rounded(const Point& p) { return {rounded(p.x()), rounded(p.y())}; }

struct Numbers {
  std::vector<double> operator()(const Point& p) const { return {rounded(p.x()), rounded(p.y())}; }
  std::vector<double> operator()(const OrientedPoint& p) const {
    return {rounded(p.position.x()), rounded(p.position.y()), rounded(p.heading_rad)};
  }
  std::vector<double> operator()(const Segment& s) const {
    return {rounded(s.begin.x()), rounded(s.begin.y()), rounded(s.end.x()), rounded(s.end.y())};
  }
  std::vector<double> operator()(const Circle& c) const {
    return {rounded(c.center.x()), rounded(c.center.y()), rounded(c.radius_m)};
  }
};

std::vector<std::vector<double>> mapped_numbers(const SemanticMap& map, const std::string& id) {
  std::vector<std::vector<double>> numbers;
  for (const MapObject& object : map.objects())
    if (object.id == id)
      for (const MapFeatureNumber feature : object.features)
        numbers.push_back(std::visit(Numbers(), map.feature(feature).geometry));
  return numbers;
}

bool is_near(const Point& a, const Point& b) {
  constexpr double kNear_m = 0.05;
  return (a - b).norm() <= kNear_m;
}

}  // namespace

const char* name_of(Answer answer) {
  switch (answer) {
    case Answer::undecided: return "undecided";
    case Answer::accepted: return "accepted";
    case Answer::refused: return "refused";
  }
  return "";
}

Subject subject_of(const SemanticMap& map, const Proposal& proposal) {
  Subject subject{proposal.id, proposal.change};
  subject.is_disputed = !objection_to(proposal).empty();
  if (proposal.change == Change::added)
    subject.face = {rounded(proposal.face.begin), rounded(proposal.face.end)};
  else
    subject.mapped = mapped_numbers(map, proposal.id);
  if (proposal.change == Change::moved) subject.moved = rounded(proposal.moved);
  return subject;
}

bool is_same(const Subject& a, const Subject& b) {
  if (a.change != b.change || a.is_disputed != b.is_disputed) return false;
  if (a.change == Change::added) return is_near(a.face.begin, b.face.begin) && is_near(a.face.end, b.face.end);
  return a.id == b.id && a.mapped == b.mapped && is_near(a.moved, b.moved);
}

}  // namespace opal
