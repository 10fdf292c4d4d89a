/// Sequential Impulses: one row after the other, over and over, each satisfied as if it were alone.
///
/// What else a solver does is said by the types it is made of: Solver<> solves J V = 0 and nothing more;
/// Solver<Clamping, Baumgarte, Friction> runs just these three.
#pragma once

#include <concepts>
#include <type_traits>

#include "chapters/01_velocity_constraint/row.h"
#include "chapters/01_velocity_constraint/rows_solved.h"

namespace pushback {

/// The moments of a step at which an effect may act, in their order. An effect is a type that derives from this one and
/// hides the moments that it needs. The first contacts.size() rows are the normals: rows[i] belongs to contacts[i].
/// An effect that appends rows of its own solves them in `sweep`. Who solves rows adds them to rows_solved.
struct Effect {
  /// What counts as overlap.
  void touch(const Contacts&, Rows&) {}
  /// Limits, biases, more rows. No impulse of this step has changed a velocity yet.
  void build(const Contacts&, Rows&, Real /*dt*/) {}
  /// The first impulses.
  void start(Rows&) {}
  /// After the normals, in every sweep.
  void sweep(Rows&) {}
  /// After the last sweep.
  void finish(Rows&) {}
  /// The contacts know their impulses now: remember, or mark them.
  void report(Contacts&, const Rows&) {}
  /// The bodies have moved. A solver with an effect that hides this moment sweeps once more after it, and reports again.
  void relax(Rows&) {}
  /// The rows have been placed anew, where an effect that relaxes has done so: what was made of them is to be made again.
  void moved(Rows&) {}
  /// The bodies have moved, and all velocities are what the step ends with. Here places may be changed, and nothing else.
  void correct(Rows&) {}
};

template <class E>
concept RelaxingEffect = !std::same_as<decltype(&E::relax), decltype(&Effect::relax)>;

template <class E>
concept CorrectingEffect = !std::same_as<decltype(&E::correct), decltype(&Effect::correct)>;

/// A misspelt moment would never be called: insist that at least one is hidden.
template <class E>
concept AnEffect = std::derived_from<E, Effect> && (!std::same_as<decltype(&E::touch), decltype(&Effect::touch)> ||
                                                    !std::same_as<decltype(&E::build), decltype(&Effect::build)> ||
                                                    !std::same_as<decltype(&E::start), decltype(&Effect::start)> ||
                                                    !std::same_as<decltype(&E::sweep), decltype(&Effect::sweep)> ||
                                                    !std::same_as<decltype(&E::finish), decltype(&Effect::finish)> ||
                                                    !std::same_as<decltype(&E::report), decltype(&Effect::report)> ||
                                                    !std::same_as<decltype(&E::moved), decltype(&Effect::moved)> ||
                                                    RelaxingEffect<E> || CorrectingEffect<E>);

template <AnEffect... Effects>
class Solver : public Effects... {
 public:
  /// Changes the velocities of the touching bodies so that they satisfy their contacts; fills Contact::impulse.
  void solve(Contacts& contacts, [[maybe_unused]] Real dt, int sweeps) {
    rows_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      rows_.emplace_back(contacts[i], contacts[i].normal, static_cast<int>(i));
      rows_.back().separation = -contacts[i].depth;
    }
    (Effects::touch(contacts, rows_), ...);
    (Effects::build(contacts, rows_, dt), ...);
    (Effects::start(rows_), ...);
    for (int i = 0; i < sweeps; ++i) sweep(contacts.size());
    (Effects::finish(rows_), ...);
    report(contacts);
  }

  /// To be called once the bodies have moved: World::step does, where a solver has it.
  void relax(Contacts& contacts)
    requires(RelaxingEffect<Effects> || ...)
  {
    (Effects::relax(rows_), ...);
    (Effects::moved(rows_), ...);
    sweep(contacts.size());
    report(contacts);
  }

  /// The last of a step, likewise.
  void correct()
    requires(CorrectingEffect<Effects> || ...)
  {
    (Effects::correct(rows_), ...);
  }

  /// The rows of the latest step.
  const Rows& rows() const { return rows_; }

 private:
  void sweep(std::size_t normals) {
    for (std::size_t i = 0; i < normals; ++i) rows_[i].solve();
    rows_solved += normals;
    (Effects::sweep(rows_), ...);
  }
  void report(Contacts& contacts) {
    for (Contact& contact : contacts) contact.impulse.setZero();
    for (const Row& row : rows_) contacts[static_cast<std::size_t>(row.contact)].impulse += row.impulse * row.n;
    (Effects::report(contacts, rows_), ...);
  }

  Rows rows_;
};

}  // namespace pushback
