#include "oracles/isolation/living_child.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <unistd.h>

namespace touchstone {
namespace {

// Each thread has one or two.
constexpr std::size_t kMostChildren = 1024;

static_assert(std::atomic<pid_t>::is_always_lock_free);

// The targets of living children; 0 where there is none.
std::array<std::atomic<pid_t>, kMostChildren> targets;
std::atomic<bool> have_ended = false;
// The process whose children they are: a forked child inherits the others. 0 before the
// first.
std::atomic<pid_t> parent = 0;

}  // namespace

LivingChild::LivingChild(pid_t target) : place_(nullptr) {
  parent = getpid();
  for (std::atomic<pid_t>& place : targets) {
    pid_t none = 0;
    if (!place.compare_exchange_strong(none, target)) continue;
    place_ = &place;
    break;
  }
  // Asked after it has its place: EndChildren() sees it there, or is seen here.
  if (have_ended) kill(target, SIGKILL);
}

LivingChild::~LivingChild() {
  if (place_ != nullptr) *place_ = 0;
}

void EndChildren() noexcept {
  if (parent != 0 && getpid() != parent) return;
  have_ended = true;
  for (const std::atomic<pid_t>& place : targets) {
    const pid_t target = place;
    if (target != 0) kill(target, SIGKILL);
  }
}

void RequireThatChildrenMayStart() {
  if (have_ended)
    throw std::system_error(ECANCELED, std::generic_category(), "this program ends");
}

}  // namespace touchstone
