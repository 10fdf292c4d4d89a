// Compiled for AVX2, as chapter 22's passes are: see passes_avx2.cpp on what must not be included here.
#include "pushback/tools/bench/peaks.h"

#include "pushback/chapters/22_wide/lanes.h"

namespace pushback {
namespace {

constexpr int bytes_of_register = 32, chains = 6;

template <class Scalar>
double multiply_and_add_in_lanes(int rounds, Scalar factor, Scalar& sink) {
  using Lanes = LanesOf<Scalar, bytes_of_register / int(sizeof(Scalar))>;
  Lanes products[chains], sums[chains];
  for (int i = 0; i < chains; ++i) products[i] = sums[i] = Scalar(i);
  for (int round = 0; round < rounds; ++round)
    for (int i = 0; i < chains; ++i) products[i] = products[i] * factor, sums[i] = sums[i] + factor;
  Lanes all = 0;
  for (int i = 0; i < chains; ++i) all = all + products[i] + sums[i];
  sink = all[0];
  return 2.0 * chains * rounds * double(Lanes::size());
}

template <class Scalar>
void add_to_all_in_lanes(Eight<Scalar>* numbers, long count, Scalar part) {
  using Lanes = LanesOf<Scalar, bytes_of_register / int(sizeof(Scalar))>;
  for (long i = 0; i < count; ++i)
    for (int at = 0; at < lanes_of_bundle; at += int(Lanes::size()))
      store(Lanes(load<Lanes>(numbers[i], at) + part), numbers[i], at);
}

}  // namespace

double multiply_and_add(int rounds, float factor, float& sink) {
  return multiply_and_add_in_lanes(rounds, factor, sink);
}
double multiply_and_add(int rounds, double factor, double& sink) {
  return multiply_and_add_in_lanes(rounds, factor, sink);
}
void add_to_all(Eight<float>* numbers, long count, float part) {
  add_to_all_in_lanes(numbers, count, part);
}
void add_to_all(Eight<double>* numbers, long count, double part) {
  add_to_all_in_lanes(numbers, count, part);
}

}  // namespace pushback
