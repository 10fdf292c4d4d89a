/// The impulse of each contact since the beginning of a step, including contacts that have parted.
#pragma once

#include <limits>
#include <vector>

#include "pushback/common/collision/contact.h"

namespace pushback {

class ContactSums {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  void clear() { sums_.clear(); }
  /// Adds an impulse on B, N s, world axes. `place`: the index of the contact's sum. If it is `none`, a sum is added and its index set.
  void add(const Contact& contact, const Vec3& impulse, std::size_t& place);
  /// Sets Contact::impulse of each of `contacts`, and inserts the contacts that have parted.
  void write_to(Contacts& contacts) const;

 private:
  Contacts sums_;  // in the order in which contacts first acted, where a contact that parts and returns appears twice
};

}  // namespace pushback
