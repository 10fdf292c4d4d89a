#include "pushback/common/experiment/row_by_row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/picture_of.h"

namespace pushback {

World on_two_corners(int boxes, const Vec3& half_extents, Real mass, const Vec3& velocity, Real friction) {
  World world;
  world.add(ground());
  for (int i = 0; i < boxes; ++i) {
    const Real bottom = 2 * half_extents.y() * static_cast<Real>(i);
    const Vec3 centre{0, bottom + half_extents.y(), 0};
    const auto body =
        static_cast<std::uint32_t>(world.add(box(half_extents, mass).at(centre).moving(velocity).coloured(2)));
    for (const std::uint32_t corner : {0U, 1U}) {
      Contact contact;
      contact.point = {corner == 0 ? -half_extents.x() : half_extents.x(), bottom, 0};
      contact.normal = Vec3::UnitY();
      contact.friction = friction;
      contact.id = {body - 1, body, corner};
      world.contacts.push_back(contact);
    }
  }
  return world;
}

void RowByRow::add(World world, std::vector<Row> rows, int solved) {
  for (Contact& contact : world.contacts) {
    contact.impulse.setZero();
    contact.state = ContactState::fresh;  // its dot has one colour, because a label gives the numbers
  }
  for (const Row& row : rows) world.contacts[row.contact].impulse += row.impulse * row.direction;
  states.push_back({std::move(world), std::move(rows), solved});
}

namespace {

/// Three digits, but none below a thousandth of `scale`.
std::string rounded(Real value, Real scale) {
  const Real last = std::pow(Real(10), std::floor(std::log10(scale)) - 3);
  Real size = std::abs(value);
  if (size < 100 * last) size = last * std::round(size / last);
  return fmt::format("{}{:.3g}", value < 0 && size > 0 ? "−" : "", size);
}

Real largest_impulse(const RowByRow& all) {
  Real largest = 0;
  for (const RowByRow::Row& row : all.states.back().rows) largest = std::max(largest, std::abs(row.impulse));
  return largest;
}

/// Whether the row's speed changes at all. That of a tangent across the picture does not.
bool matters(const RowByRow& all, std::size_t row) {
  return std::any_of(all.states.begin(), all.states.end(),
                     [row](const RowByRow::State& state) { return std::abs(state.rows[row].speed) > Real(1e-9); });
}

/// The lines beside a contact, each with its style.
std::string label_of(const RowByRow& all, const RowByRow::State& state, std::size_t contact) {
  const std::size_t contacts = state.world.contacts.size();
  const char* const numbered = contacts != 2 ? "Σλ" : contact == 0 ? "Σλ₁" : "Σλ₂";
  const char* const normal = state.rows.size() > contacts ? "Σλₙ" : numbered;
  std::vector<std::string> lines;
  const auto add = [&lines](const char* style, const std::string& text) {
    lines.push_back(fmt::format(R"(["{}", "{}"])", style, text));
  };
  for (std::size_t i = 0; i < state.rows.size(); ++i) {
    const RowByRow::Row& row = state.rows[i];
    if (row.contact != contact || !matters(all, i)) continue;
    const bool rubs = i >= contacts;
    const Real largest = largest_impulse(all);
    add("sum", fmt::format("{} {} N s", rubs ? "Σλₜ" : normal, rounded(row.impulse, largest)));
    if (rubs && std::isfinite(row.limit)) add("", fmt::format("limit ±{}", rounded(row.limit, largest)));
    const std::string speed = rounded(std::abs(row.speed), all.speed);
    const char* const way = speed == "0" ? "" : row.speed > 0 ? (rubs ? "→ " : "↑ ") : (rubs ? "← " : "↓ ");
    add(row.error > all.speed / 2000 ? "unsolved" : "", fmt::format("{}{} m/s", way, speed));
  }
  return fmt::format("[{}]", fmt::join(lines, ", "));
}

std::string sentence_of(const RowByRow& all, std::size_t index) {
  const RowByRow::State& state = all.states[index];
  if (state.solved < 0) return "No row is solved yet.";
  const std::vector<RowByRow::Row>& before = all.states[index - 1].rows;
  const auto change = [&](std::size_t row) { return state.rows[row].impulse - before[row].impulse; };
  auto row = static_cast<std::size_t>(state.solved);
  const std::size_t contacts = state.world.contacts.size();
  const bool rubs = row >= contacts;
  if (rubs && std::abs(change(row - 1)) > std::abs(change(row))) --row;  // of the two tangents
  const std::size_t turns = contacts * (state.rows.size() > contacts ? 2 : 1);
  const Real largest = largest_impulse(all);
  return fmt::format("Sweep {}, row {}: {} goes from {} to {} N s, a correction of {} N s.", (index - 1) / turns + 1,
                     (index - 1) % turns + 1, rubs ? "friction" : "the impulse", rounded(before[row].impulse, largest),
                     rounded(state.rows[row].impulse, largest), rounded(change(row), largest));
}

}  // namespace

std::string RowByRow::in_json() const {
  std::vector<std::string> points, all;
  for (const Contact& contact : states[0].world.contacts)
    points.push_back(fmt::format("[{}, {}]", contact.point.x(), contact.point.y()));
  for (std::size_t i = 0; i < states.size(); ++i) {
    std::vector<std::string> labels;
    for (std::size_t contact = 0; contact < points.size(); ++contact)
      labels.push_back(label_of(*this, states[i], contact));
    const int solved = states[i].solved;
    all.push_back(
        fmt::format(R"({{"solved": {}, "said": "{}", "labels": [{}]}})",
                    solved < 0 ? -1 : static_cast<int>(states[i].rows[static_cast<std::size_t>(solved)].contact),
                    sentence_of(*this, i), fmt::join(labels, ", ")));
  }
  const Body& last = states[0].world.bodies.back();
  const Real top = last.position.y() + std::get<Box>(last.shape).half_extents.y();
  return fmt::format(R"({{"top": {}, "points": [{}], "states": [{}]}})", top, fmt::join(points, ", "),
                     fmt::join(all, ",\n"));
}

Picture RowByRow::picture(std::size_t state, const Camera& camera) const {
  // In front of the bodies, so that they hide no arrow.
  World drawn = states.at(state).world;
  const Real front = std::get<Box>(drawn.bodies.back().shape).half_extents.z() + Real(0.05);
  for (Contact& contact : drawn.contacts) contact.point.z() = front;
  Picture picture = picture_of(drawn, camera, Real(0.95) / largest_impulse(*this));
  const Real unit = camera.height_at(Vec3(0, 0, front));
  const auto across = [](const Vec3& way) { return std::abs(way.y()) < std::abs(way.x()); };
  for (Arrow& impulse : picture.arrows) {
    impulse.thickness *= 2;
    if (!across(impulse.tip - impulse.tail)) continue;
    const Vec3 up(0, Real(0.025) * unit, 0), way = impulse.tip - impulse.tail;  // not in the ground
    if (way.x() * impulse.tail.x() > 0) impulse.tip = impulse.tail, impulse.tail -= way;
    impulse.tail += up;
    impulse.tip += up;
  }
  for (Dot& dot : picture.dots) dot.radius *= Real(0.6);
  for (const Row& row : states[state].rows) {
    if (row.error < speed / 1000) continue;
    const Vec3& point = drawn.contacts[row.contact].point;
    // Beside the contact. Along a surface it is over the body, because the labels are outside.
    const bool along = across(row.direction);
    const Real outward = (point.x() < 0 ? -Real(0.04) : Real(0.04)) * unit;
    const Vec3 from = point + (along ? Vec3(-outward, Real(0.065) * unit, 0) : Vec3(outward, 0, 0));
    Vec3 way = (along ? Real(0.1) : Real(0.21)) * unit * row.error / speed * row.direction;
    const bool turned = along && way.x() * outward > 0;
    if (turned) way = -way;
    Vec3 tail = from, tip = from + way;
    if ((row.speed < 0) != turned) std::swap(tail, tip);
    picture.arrows.push_back({tail, tip, 2 * arrow_thickness(camera, point), body_colour(4)});
  }
  return picture;
}

}  // namespace pushback
