#include "oracles/isolation/motion_store.h"

#include <cerrno>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "oracles/isolation/answer_wire.h"

namespace touchstone {
namespace {

[[noreturn]] void Fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

// Returns whether a call that moves bytes was interrupted before it moved any.
bool IsInterrupted(ssize_t count) {
  return count < 0 && errno == EINTR;
}

}  // namespace

MotionStore::MotionStore() : file_(memfd_create("touchstone-motions", MFD_CLOEXEC)) {
  if (file_.get() < 0) Fail(errno, "memfd_create");
}

MotionStore::Place MotionStore::Keep(const Trajectory& motion) {
  const std::string bytes = ToWire(motion);
  Place place{0, bytes.size()};
  {
    const std::lock_guard lock(mutex_);
    place.begin = end_;
    end_ += static_cast<off_t>(bytes.size());
  }
  off_t at = place.begin;
  for (std::string_view rest = bytes; !rest.empty();) {
    const ssize_t count = pwrite(file_.get(), rest.data(), rest.size(), at);
    if (IsInterrupted(count)) continue;
    if (count <= 0) Fail(count < 0 ? errno : ENOSPC, "pwrite");
    rest.remove_prefix(static_cast<std::size_t>(count));
    at += count;
  }
  return place;
}

Trajectory MotionStore::Take(const Place& place) {
  std::string bytes(place.size, '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = pread(file_.get(), bytes.data() + done, bytes.size() - done,
                                place.begin + static_cast<off_t>(done));
    if (IsInterrupted(count)) continue;
    if (count <= 0) Fail(count < 0 ? errno : EIO, "pread");
    done += static_cast<std::size_t>(count);
  }
  // Whole pages only; a failure costs memory until the end.
  fallocate(file_.get(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, place.begin,
            static_cast<off_t>(place.size));
  std::optional<Trajectory> motion = TrajectoryFromWire(bytes);
  if (!motion) Fail(EIO, "a kept motion");
  return *std::move(motion);
}

}  // namespace touchstone
