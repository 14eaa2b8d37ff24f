// SPDX-License-Identifier: Apache-2.0
#include "traffic/overrun.hpp"

#include <algorithm>

namespace thalweg {

void Overrun::predicted(VehicleId vehicle, Millis now, Millis arrival, bool is_new_way) {
  std::vector<Prediction>& own = open_[vehicle];
  if (is_new_way) own.clear();
  own.push_back({.made = now, .arrival = arrival});
}

void Overrun::observe(const Fleet& fleet, Millis now) {
  const double fading = fading_.advance(now);
  for (double* sum : {&n_, &x_, &y_, &xx_, &xy_}) *sum *= fading;
  open_.settle(fleet, [&](const std::vector<Prediction>& predictions) {
    for (const Prediction& prediction : predictions) {
      const double foretold = to_seconds(prediction.arrival - prediction.made);
      const double most = options_.most + options_.most_share * foretold;
      const double more = std::clamp(to_seconds(now - prediction.arrival), -most, most);
      n_ += 1;
      x_ += foretold;
      y_ += more;
      xx_ += foretold * foretold;
      xy_ += foretold * more;
    }
  });
  if (n_ <= 0) return;
  // The prior's predictions are as long as those that were seen, and came true.
  const double with_prior = 1 + options_.prior / n_;
  const double n = n_ * with_prior;
  const double x = x_ * with_prior;
  const double spread = xx_ * with_prior - x * x / n;
  share_ = spread > 0 ? (xy_ - x * y_ / n) / spread : 0;
  offset_ = (y_ - share_ * x) / n;
}

Millis Overrun::later(Millis left) const {
  return std::max(-left, from_seconds(offset_) + static_cast<Millis>(share_ * static_cast<double>(left)));
}

}  // namespace thalweg
