#include "pushback/common/experiment/played.h"

#include <algorithm>
#include <iterator>

namespace pushback {

namespace {

std::vector<ContactId> ids_of(const Contacts& contacts) {
  std::vector<ContactId> ids;
  for (const Contact& contact : contacts) ids.push_back(contact.id);
  return ids;
}

int count_missing(const std::vector<ContactId>& from, const std::vector<ContactId>& in) {
  std::vector<ContactId> missing;
  std::set_difference(from.begin(), from.end(), in.begin(), in.end(), std::back_inserter(missing));
  return static_cast<int>(missing.size());
}

}  // namespace

Experiment::Played::Played(const Experiment& of, const Variant& variant)
    : experiment_(&of), variant_(&variant), step_(variant.step) {
  of.fill(world, variant);
}

Sample Experiment::Played::step() {
  Sample sample;
  const Real dt = experiment_->dt_ / static_cast<Real>(variant_->substeps);
  for (int i = 0; i < variant_->substeps; ++i) step_(world, dt, experiment_->sweeps_of(*variant_), sample);
  sample.time = static_cast<Real>(++steps_) * experiment_->dt_;
  sample.kinetic_energy = kinetic_energy(world);
  sample.potential_energy = potential_energy(world);
  sample.momentum = momentum(world);
  sample.angular_momentum = angular_momentum(world);
  sample.overlap = deepest_overlap(world);
  sample.contacts = static_cast<int>(world.contacts.size());
  std::vector<ContactId> now = ids_of(world.contacts);
  sample.found = count_missing(now, contacts_before_);
  sample.lost = count_missing(contacts_before_, now);
  contacts_before_ = std::move(now);
  return sample;
}

}  // namespace pushback
