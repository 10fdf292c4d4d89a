/// The momentum that each contact gave since a step began, also contacts that have parted.
#pragma once

#include <limits>
#include <vector>

#include "pushback/common/collision/contact.h"

namespace pushback {

class ContactSums {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  void clear() { sums_.clear(); }
  /// Adds an impulse, N s, on B, world axes. `place` is the contact's place among the sums. `none` gives it a new one.
  void add(const Contact& contact, const Vec3& impulse, std::size_t& place);
  /// Sets Contact::impulse of each of `contacts`, and lists those that have parted among them.
  void write_to(Contacts& contacts) const;

 private:
  Contacts sums_;  // in the order of first action; a contact that parts and returns appears twice
};

}  // namespace pushback
