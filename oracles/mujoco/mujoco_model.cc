#include "oracles/mujoco/mujoco_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <sys/mman.h>

namespace touchstone {
namespace {

using Eigen::Vector3d;

/** Returns memory for MuJoCo, which aligns to 64 bytes, in pages of 2 MiB from that size
 on. MuJoCo clears all memory of a world, and for a pile of boxes most of that time goes
 into faults of small pages: clearing 280 MB took 0.29 s, and 0.06 s with large ones. */
void* Allocate(std::size_t bytes) {
  constexpr std::size_t kLine = 64;
  constexpr std::size_t kLargePage = std::size_t{1} << 21;
  const std::size_t alignment = bytes < kLargePage ? kLine : kLargePage;
  const std::size_t size = (bytes + alignment - 1) / alignment * alignment;
  void* const memory = std::aligned_alloc(alignment, size);
  // Advice only: without large pages the memory is as good, but slower to clear.
  if (memory != nullptr && alignment == kLargePage) madvise(memory, size, MADV_HUGEPAGE);
  return memory;
}

std::string Text(const Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

// The attributes of a shape. The size of a plane is only used for rendering. A hull is
// the mesh of the given name.
std::string GeomOf(const Shape& shape, const std::string& mesh) {
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    return fmt::format(R"(type="sphere" size="{}")", sphere->radius);
  if (const auto* box = std::get_if<Box>(&shape))
    return fmt::format(R"(type="box" size="{}")", Text(box->half_extents));
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return fmt::format(R"(type="capsule" size="{} {}")", capsule->radius,
                       capsule->half_length);
  if (const auto* cylinder = std::get_if<Cylinder>(&shape))
    return fmt::format(R"(type="cylinder" size="{} {}")", cylinder->radius,
                       cylinder->half_length);
  if (std::holds_alternative<ConvexHull>(shape))
    return fmt::format(R"(type="mesh" mesh="{}")", mesh);
  return R"(type="plane" size="0 0 1")";
}

std::string Mesh(const std::string& name, const ConvexHull& hull) {
  std::string vertices;
  for (const Vector3d& vertex : hull.vertices) vertices += Text(vertex) + "  ";
  return fmt::format(R"(<mesh name="{}" vertex="{}"/>)", name, vertices);
}

std::string PlaceOf(const Pose& X_WB) {
  const Eigen::Quaterniond q = X_WB.q_WB ? *X_WB.q_WB : Eigen::Quaterniond(X_WB.R_WB);
  return fmt::format(R"(pos="{}" quat="{} {} {} {}")", Text(X_WB.p_WB), q.w(), q.x(),
                     q.y(), q.z());
}

std::string Site(std::string_view name, const Vector3d& p) {
  return fmt::format(R"(<site name="{}" pos="{}"/>)", name, Text(p));
}

/** Writes a world as MJCF. The ends of springs and joints become sites of their bodies.
 */
class Writer {
 public:
  Writer(const World& world, std::size_t contacts)
      : world_(world), room_(contacts), sites_(world.bodies.size()) {
    for (std::size_t i = 0; i < world.springs.size(); ++i) {
      const Spring& spring = world.springs[i];
      Connect(fmt::format("s{}", i), spring.A, spring.B,
              fmt::format(R"(stiffness="{}" damping="{}" springlength="{}")",
                          spring.stiffness, spring.damping, spring.rest_length));
    }
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
      const std::string name = fmt::format("j{}", i);
      if (Connect(name, world.joints[i].A, world.joints[i].B, ""))
        equalities_ += fmt::format(R"(<tendon name="{0}" tendon1="{0}"/>)", name);
    }
    bool one_friction = true;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      Add(i);
      one_friction &= world.bodies[i].friction == world.bodies[0].friction;
    }
    if (!one_friction) AddPairs();
  }

  std::string operator()() const {
    const std::size_t contacts = MostContacts();
    const std::size_t rows = 4 * contacts + world_.joints.size();
    // MuJoCo counts the bytes of its buffer in an int. The buffer holds numbers and
    // indices for matrices of size rows × rows, and twice for rows × degrees of freedom.
    const double bytes = 12.0 * static_cast<double>(rows * (rows + 2 * Freedoms()));
    if (bytes > std::numeric_limits<int>::max()) {
      throw std::runtime_error(
          fmt::format("MuJoCo cannot hold {} contacts of {} bodies: its limit is 2 GiB",
                      contacts, world_.bodies.size()));
    }
    return fmt::format(
        R"(<mujoco><compiler angle="radian"/><size nconmax="{}" njmax="{}" nstack="{}"/>)"
        R"(<option collision="{}"/><asset>{}</asset><worldbody>{}{}</worldbody>)"
        R"(<contact>{}</contact>)"
        R"(<tendon>{}</tendon><equality>{}</equality></mujoco>)",
        contacts, rows, StackFor(rows), pairs_.empty() ? "dynamic" : "predefined",
        meshes_, world_sites_, bodies_, pairs_, tendons_, equalities_);
  }

 private:
  const RigidBody& BodyAt(std::size_t i) const { return world_.bodies[i]; }

  static bool CanTouch(const RigidBody& A, const RigidBody& B) {
    return A.collides && B.collides && (A.mass > 0 || B.mass > 0);
  }

  /** Returns the number of contacts for which memory is reserved. */
  std::size_t MostContacts() const {
    std::size_t contacts = 1;
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      for (std::size_t j = 0; j < i && contacts < room_; ++j) {
        if (!CanTouch(BodyAt(i), BodyAt(j))) continue;
        const bool round = KindOf(BodyAt(i).placed.shape) == ShapeKind::kSphere ||
                           KindOf(BodyAt(j).placed.shape) == ShapeKind::kSphere;
        contacts += round ? 1 : 8;  // MuJoCo returns at most eight, for two boxes.
      }
    }
    return std::min(contacts, room_);
  }

  std::size_t Freedoms() const { return 6 * world_.bodies.size(); }

  /** Returns the size of MuJoCo's stack, in numbers. According to measurements its solver
   needs three times the square of the degrees of freedom, and a row per constraint. Its
   own default is five times the square of the sum of both. */
  std::size_t StackFor(std::size_t rows) const {
    const std::size_t freedoms = Freedoms();
    return 4 * freedoms * freedoms + rows * freedoms + 200 * (rows + freedoms);
  }

  bool Moves(const Anchor& anchor) const {
    return anchor.on == AnchorKind::kBody &&
           BodyAt(static_cast<std::size_t>(anchor.index)).mass > 0;
  }

  /** Adds a tendon between two points, unless neither can move. */
  bool Connect(const std::string& name, const Anchor& A, const Anchor& B,
               std::string_view attributes) {
    if (!Moves(A) && !Moves(B)) return false;
    tendons_ += fmt::format(R"(<spatial name="{}" {}>)", name, attributes);
    for (const Anchor* anchor : {&A, &B}) {
      const std::string site = name + (anchor == &A ? "A" : "B");
      tendons_ += fmt::format(R"(<site site="{}"/>)", site);
      if (Moves(*anchor)) {
        sites_[static_cast<std::size_t>(anchor->index)] += Site(site, anchor->point);
      } else {
        world_sites_ += Site(site, StartOf(world_, *anchor));
      }
    }
    tendons_ += "</spatial>";
    return true;
  }

  void Add(std::size_t i) {
    const RigidBody& body = BodyAt(i);
    const bool moves = body.mass > 0;
    std::string geom;
    if (body.collides) {
      const std::string mesh = fmt::format("m{}", i);
      if (const auto* hull = std::get_if<ConvexHull>(&body.placed.shape))
        meshes_ += Mesh(mesh, *hull);
      geom = fmt::format(
          R"(<geom name="g{}" {} {} {}/>)", i, GeomOf(body.placed.shape, mesh),
          moves ? "" : PlaceOf(body.placed.X_WB), FrictionOf(body.friction));
    }
    if (!moves) {
      bodies_ += geom;
      return;
    }
    bodies_ += fmt::format(
        R"(<body name="b{}" {}><freejoint/>)"
        R"(<inertial pos="0 0 0" mass="{}" diaginertia="{}"/>{}{}</body>)",
        i, PlaceOf(body.placed.X_WB), body.mass, Text(InertiaOf(body)), geom, sites_[i]);
  }

  // A frictionless contact must have dimension 1: with more dimensions, friction is at
  // least 1e-5 (mjMINMU).
  static std::string FrictionOf(double mu) {
    return fmt::format(R"(condim="{}" friction="{} 0 0")", mu > 0 ? 3 : 1, mu);
  }

  // Adds explicit pairs with their friction. Without them MuJoCo uses the larger friction
  // of the two geoms.
  void AddPairs() {
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < world_.bodies.size(); ++j) {
        const RigidBody& A = BodyAt(i);
        const RigidBody& B = BodyAt(j);
        if (!CanTouch(A, B)) continue;
        const double mu = std::sqrt(A.friction * B.friction);
        pairs_ += fmt::format(
            R"(<pair geom1="g{}" geom2="g{}" condim="{}" friction="{} {} 0 0 0"/>)", i, j,
            mu > 0 ? 3 : 1, mu, mu);
      }
    }
  }

  const World& world_;
  std::size_t room_;
  std::vector<std::string> sites_;  // Sites indexed by body.
  std::string world_sites_;
  std::string meshes_;
  std::string bodies_;
  std::string pairs_;
  std::string tendons_;
  std::string equalities_;
};

}  // namespace

void InitialiseMujoco() {
  // A registry of oracles may be made while another thread simulates with these hooks.
  static std::once_flag once;
  std::call_once(once, [] {
    mju_user_malloc = &Allocate;
    mju_user_free = &std::free;
    mju_user_warning = [](const char* what) { std::fprintf(stderr, "%s\n", what); };
    mju_user_error = [](const char* what) {
      std::fprintf(stderr, "%s\n", what);
      std::abort();
    };
  });
}

MujocoModel Compile(const std::string& mjcf) {
  static std::mutex mutex;  // The reader keeps the last model in a global variable.
  const std::lock_guard lock(mutex);
  static const char* const kName = "world.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(mjcf.size())) != 0)
    throw std::runtime_error("MuJoCo cannot hold a model of this size");
  const int file = mj_findFileVFS(files.get(), kName);
  mjcf.copy(static_cast<char*>(files->filedata[file]), mjcf.size());
  std::array<char, 500> error{};
  MujocoModel model(
      mj_loadXML(kName, files.get(), error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(error.data());
  return model;
}

std::string ToMjcf(const World& world, std::size_t contacts) {
  return Writer(world, contacts)();
}

}  // namespace touchstone
