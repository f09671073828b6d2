#include "reports/reproduce/engine_code.h"

#include <fmt/format.h>

namespace touchstone {

EngineCode CodeOf(const ContactQuery& query, const OracleInfo& oracle) {
  if (oracle.external) {
    throw CannotReproduce(fmt::format(
        "{} is a program of its own, and what it calls is not known", oracle.name));
  }
  if (oracle.library == "Bullet") return BulletCode(query, oracle.name);
  if (oracle.library == "libccd") return CcdCode(query, oracle.name);
  if (oracle.library == "DART") return DartCode(query, oracle.name);
  if (oracle.library == "FCL") return FclCode(query, oracle.name);
  if (oracle.library == "MuJoCo") return MujocoCode(query, oracle.name);
  if (oracle.library == "ODE") return OdeCode(query, oracle.name);
  throw CannotReproduce(
      fmt::format("{} is no engine of its own; expected an oracle of FCL, libccd, "
                  "Bullet, ODE, MuJoCo or DART",
                  oracle.name));
}

}  // namespace touchstone
