#include "reports/writers/world_sums.h"

namespace touchstone {
namespace {

SecondsByName SumOf(const RunReport& report, SecondsByName WorldSeconds::*part) {
  SecondsByName sum;
  for (const WorldResult& result : report.worlds) {
    for (const WorldSeconds& seconds : result.seconds) {
      for (const auto& [name, value] : seconds.*part) sum[name] += value;
    }
  }
  return sum;
}

}  // namespace

SecondsByName SecondsOfMotions(const RunReport& report) {
  return SumOf(report, &WorldSeconds::motions);
}

SecondsByName SecondsOfLaws(const RunReport& report) {
  return SumOf(report, &WorldSeconds::laws);
}

}  // namespace touchstone
