#include <cstddef>

#include "reports/shrink/reductions.h"

namespace touchstone {

void EqualSizes(const Question& question, const Candidates& take) {
  const auto sizes_of = [](Question& of) {
    std::vector<double*> sizes;
    for (Body* const body : BodiesOf(of)) {
      for (double* const size : SizesOf(body->shape)) sizes.push_back(size);
    }
    return sizes;
  };
  // All sizes of a body at once.
  for (std::size_t b = 0; b < BodiesOf(question).size(); ++b) {
    Shape shape = BodiesOf(question)[b]->shape;
    for (const double* const size : SizesOf(shape)) {
      Question equal = question;
      for (double* const each : SizesOf(BodiesOf(equal)[b]->shape)) *each = *size;
      take(std::move(equal));
    }
  }
  // One size like another.
  Question copy = question;
  const std::vector<double*> sizes = sizes_of(copy);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    for (std::size_t j = 0; j < sizes.size(); ++j) {
      if (*sizes[i] == *sizes[j]) continue;
      Question equal = question;
      *sizes_of(equal)[i] = *sizes[j];
      take(std::move(equal));
    }
  }
}

}  // namespace touchstone
