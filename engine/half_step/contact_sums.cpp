#include "pushback/engine/half_step/contact_sums.h"

#include <algorithm>

namespace pushback {

void ContactSums::add(const Contact& contact, const Vec3& impulse, std::size_t& place) {
  if (place == none) place = sums_.size(), sums_.emplace_back();
  const Vec3 sum = sums_[place].impulse + impulse;
  sums_[place] = contact;
  sums_[place].impulse = sum;
}

void ContactSums::write_to(Contacts& contacts) const {
  Contacts sums = sums_;
  const auto before = [](const Contact& p, const Contact& q) { return p.id < q.id; };
  if (!std::is_sorted(sums.begin(), sums.end(), before)) std::stable_sort(sums.begin(), sums.end(), before);
  Contacts all;
  auto sum = sums.begin();  // both lists ascend, so go through them in parallel
  const auto parted = [&] {
    if (!all.empty() && all.back().id == sum->id) return void(all.back().impulse += sum->impulse);  // it had come back
    all.push_back(*sum);
    all.back().parted = true;
    all.back().last_impulse.setZero();
  };
  for (const Contact& contact : contacts) {
    for (; sum != sums.end() && sum->id < contact.id; ++sum) parted();
    all.push_back(contact);
    all.back().impulse.setZero();
    for (; sum != sums.end() && sum->id == contact.id; ++sum) all.back().impulse += sum->impulse;
  }
  for (; sum != sums.end(); ++sum) parted();
  std::erase_if(all, [](const Contact& contact) { return contact.parted && contact.impulse.isZero(0); });
  contacts.swap(all);
}

}  // namespace pushback
