#include "reports/adapter_check/contact_mistakes.h"

#include <cmath>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

namespace touchstone {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

using ShapeChange = std::function<std::optional<Shape>(const Shape&)>;
using PoseChange = std::function<std::optional<Pose>(const Body&)>;

// A mistake with the shape of each body.
ContactMistake OfShapes(std::string sentence, const ShapeChange& change) {
  return {std::move(sentence),
          [change](const ContactQuery& query) -> std::optional<ContactQuery> {
            const std::optional<Shape> A = change(query.A.shape);
            const std::optional<Shape> B = change(query.B.shape);
            if (!A && !B) return std::nullopt;
            ContactQuery asked = query;
            if (A) asked.A.shape = *A;
            if (B) asked.B.shape = *B;
            return asked;
          },
          {}};
}

// A mistake with the pose of each body.
ContactMistake OfPoses(std::string sentence, const PoseChange& change) {
  return {std::move(sentence),
          [change](const ContactQuery& query) -> std::optional<ContactQuery> {
            const std::optional<Pose> A = change(query.A);
            const std::optional<Pose> B = change(query.B);
            if (!A && !B) return std::nullopt;
            ContactQuery asked = query;
            if (A) asked.A.X_WB = *A;
            if (B) asked.B.X_WB = *B;
            return asked;
          },
          {}};
}

ContactMistake OfAnswers(
    std::string sentence,
    std::function<std::optional<ContactAnswer>(const ContactQuery&, const ContactAnswer&)>
        meant) {
  return {std::move(sentence), {}, std::move(meant)};
}

ShapeChange BoxTimes(double factor) {
  return [factor](const Shape& shape) -> std::optional<Shape> {
    if (!std::holds_alternative<Box>(shape)) return std::nullopt;
    return Resized(shape, factor);
  };
}

/** Multiplies the radius and the half length or height of a round shape. */
struct RoundTimes {
  double radius;
  double length;

  std::optional<Shape> operator()(const Shape& shape) const {
    return std::visit(*this, shape);
  }
  std::optional<Shape> operator()(const Sphere& sphere) const {
    if (radius == 1) return std::nullopt;
    return Sphere{radius * sphere.radius};
  }
  std::optional<Shape> operator()(const Capsule& capsule) const {
    return Capsule{radius * capsule.radius, length * capsule.half_length};
  }
  std::optional<Shape> operator()(const Cylinder& cylinder) const {
    return Cylinder{radius * cylinder.radius, length * cylinder.half_length};
  }
  std::optional<Shape> operator()(const Cone& cone) const {
    return Cone{radius * cone.radius, length * cone.half_height};
  }
  template <typename Other>
  std::optional<Shape> operator()(const Other&) const {
    return std::nullopt;
  }
};

ShapeChange CapsuleLongerBy(double radii) {
  return [radii](const Shape& shape) -> std::optional<Shape> {
    const auto* capsule = std::get_if<Capsule>(&shape);
    if (capsule == nullptr) return std::nullopt;
    const double half_length = capsule->half_length + radii * capsule->radius;
    // A capsule whose segment vanishes is a ball.
    if (half_length <= 0) return Sphere{capsule->radius};
    return Capsule{capsule->radius, half_length};
  };
}

bool HasAxis(const Shape& shape) {
  return std::holds_alternative<Capsule>(shape) ||
         std::holds_alternative<Cylinder>(shape) || std::holds_alternative<Cone>(shape);
}

// A shape whose axis is along `axis` of the body where ours is along z.
PoseChange AxisAlong(const Vector3d& axis) {
  const Matrix3d turn =
      Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
  return [turn](const Body& body) -> std::optional<Pose> {
    if (!HasAxis(body.shape)) return std::nullopt;
    return Pose::FromMatrix(body.X_WB.p_WB, body.X_WB.R_WB * turn);
  };
}

Quaterniond QuaternionOf(const Pose& pose) {
  return pose.q_WB ? *pose.q_WB : Quaterniond(pose.R_WB).normalized();
}

bool IsRound(const Body& body) {
  return std::holds_alternative<Sphere>(body.shape);
}

// A pose with another rotation, which a sphere does not have.
PoseChange Turned(const std::function<Matrix3d(const Pose&)>& rotation) {
  return [rotation](const Body& body) -> std::optional<Pose> {
    if (IsRound(body)) return std::nullopt;
    return Pose::FromMatrix(body.X_WB.p_WB, rotation(body.X_WB));
  };
}

// A shape whose centre lies `share` of its size from the position. Share 1 of a box: the
// position is that of its least corner; of a shape with an axis: of its lower end.
PoseChange CentreOff(double share) {
  return [share](const Body& body) -> std::optional<Pose> {
    Vector3d to_centre;
    if (const auto* box = std::get_if<Box>(&body.shape))
      to_centre = box->half_extents;
    else if (const auto* cylinder = std::get_if<Cylinder>(&body.shape))
      to_centre = {0, 0, cylinder->half_length};
    else if (const auto* cone = std::get_if<Cone>(&body.shape))
      to_centre = {0, 0, cone->half_height};
    else if (const auto* capsule = std::get_if<Capsule>(&body.shape))
      to_centre = {0, 0, capsule->half_length};
    else
      return std::nullopt;
    Pose pose = body.X_WB;
    pose.p_WB += share * (pose.R_WB * to_centre);
    return pose;
  };
}

/** Changes every normal, separation and point of an answer. */
struct EachOf {
  std::function<Vector3d(const Vector3d&)> normal = [](const Vector3d& n) { return n; };
  std::function<double(double)> separation = [](double s) { return s; };
  std::function<Vector3d(const Vector3d&)> point = [](const Vector3d& p) { return p; };

  ContactAnswer Of(const ContactAnswer& answer) const {
    ContactAnswer changed = answer;
    if (changed.n_AB_W) changed.n_AB_W = normal(*changed.n_AB_W);
    if (changed.separation) changed.separation = separation(*changed.separation);
    for (ContactPoint& contact : changed.points) {
      contact.p_WC = point(contact.p_WC);
      contact.separation = separation(contact.separation);
      if (contact.n_AB_W) contact.n_AB_W = normal(*contact.n_AB_W);
    }
    if (changed.witnesses) {
      changed.witnesses =
          WitnessPoints{point(changed.witnesses->p_WCa), point(changed.witnesses->p_WCb)};
    }
    return changed;
  }
};

// An answer whose vectors are in the frame of a body.
ContactMistake InFrameOf(std::string sentence, Body ContactQuery::*body) {
  return OfAnswers(std::move(sentence), [body](const ContactQuery& query,
                                               const ContactAnswer& answer) {
    const Pose X_WB = (query.*body).X_WB;
    EachOf each;
    each.normal = [&](const Vector3d& n) { return Vector3d(X_WB.R_WB * n); };
    each.point = [&](const Vector3d& p) { return Vector3d(X_WB * p); };
    return std::optional(each.Of(answer));
  });
}

// An answer whose normals alone are in the frame of a body.
ContactMistake NormalInFrameOf(std::string sentence, Body ContactQuery::*body) {
  return OfAnswers(std::move(sentence),
                   [body](const ContactQuery& query, const ContactAnswer& answer) {
                     const Matrix3d R_WB = (query.*body).X_WB.R_WB;
                     EachOf each;
                     each.normal = [&](const Vector3d& n) { return Vector3d(R_WB * n); };
                     return std::optional(each.Of(answer));
                   });
}

std::optional<ContactAnswer> WithPointsMoved(const ContactAnswer& answer, double share) {
  if (answer.points.empty() || !answer.n_AB_W) return std::nullopt;
  ContactAnswer meant = answer;
  for (ContactPoint& contact : meant.points)
    contact.p_WC += share * contact.separation * contact.n_AB_W.value_or(*answer.n_AB_W);
  return meant;
}

// An answer whose separations are ours divided by `factor`.
ContactMistake OfSeparations(std::string sentence, double factor) {
  return OfAnswers(std::move(sentence),
                   [factor](const ContactQuery&,
                            const ContactAnswer& answer) -> std::optional<ContactAnswer> {
                     EachOf each;
                     each.separation = [factor](double s) { return factor * s; };
                     return each.Of(answer);
                   });
}

std::vector<ContactMistake> MistakesWithAnswers() {
  const auto flip = [](const Vector3d& n) { return Vector3d(-n); };
  std::vector<ContactMistake> mistakes;
  mistakes.push_back(OfAnswers("its normal points from B to A; expected from A to B",
                               [flip](const ContactQuery&, const ContactAnswer& answer)
                                   -> std::optional<ContactAnswer> {
                                 EachOf each;
                                 each.normal = flip;
                                 return each.Of(answer);
                               }));
  mistakes.push_back(OfAnswers(
      "its separation of bodies that overlap is positive, a depth; expected a negative "
      "number",
      [](const ContactQuery&,
         const ContactAnswer& answer) -> std::optional<ContactAnswer> {
        if (!answer.touching) return std::nullopt;
        EachOf each;
        each.separation = [](double s) { return -s; };
        return each.Of(answer);
      }));
  mistakes.push_back(OfAnswers(
      "its separation has the wrong sign; expected negative for bodies that overlap, "
      "positive for bodies apart",
      [](const ContactQuery&,
         const ContactAnswer& answer) -> std::optional<ContactAnswer> {
        EachOf each;
        each.separation = [](double s) { return -s; };
        return each.Of(answer);
      }));
  mistakes.push_back(OfAnswers(
      "its separation has the wrong sign, and `touching` with it; expected a negative "
      "separation of bodies that overlap",
      [](const ContactQuery&,
         const ContactAnswer& answer) -> std::optional<ContactAnswer> {
        EachOf each;
        each.separation = [](double s) { return -s; };
        ContactAnswer meant = each.Of(answer);
        meant.touching = !answer.touching;
        return meant;
      }));
  mistakes.push_back(
      OfSeparations("its separation is half of what it is along the normal", 2));
  mistakes.push_back(
      OfSeparations("its separation is twice what it is along the normal", 0.5));
  mistakes.push_back(OfAnswers(
      "its contact points lie on the surface of A; expected midway between the surfaces",
      [](const ContactQuery&, const ContactAnswer& answer) {
        return WithPointsMoved(answer, 0.5);
      }));
  mistakes.push_back(OfAnswers(
      "its contact points lie on the surface of B; expected midway between the surfaces",
      [](const ContactQuery&, const ContactAnswer& answer) {
        return WithPointsMoved(answer, -0.5);
      }));
  mistakes.push_back(
      OfAnswers("its witness points are exchanged; expected that of A first",
                [](const ContactQuery&,
                   const ContactAnswer& answer) -> std::optional<ContactAnswer> {
                  if (!answer.witnesses) return std::nullopt;
                  ContactAnswer meant = answer;
                  std::swap(meant.witnesses->p_WCa, meant.witnesses->p_WCb);
                  return meant;
                }));
  mistakes.push_back(
      InFrameOf("its normal and points are in the frame of A; expected the world's",
                &ContactQuery::A));
  mistakes.push_back(
      InFrameOf("its normal and points are in the frame of B; expected the world's",
                &ContactQuery::B));
  mistakes.push_back(NormalInFrameOf(
      "its normal is in the frame of A; expected the world's", &ContactQuery::A));
  mistakes.push_back(NormalInFrameOf(
      "its normal is in the frame of B; expected the world's", &ContactQuery::B));
  mistakes.push_back(OfAnswers(
      "its points are relative to the position of A; expected world coordinates",
      [](const ContactQuery& query,
         const ContactAnswer& answer) -> std::optional<ContactAnswer> {
        EachOf each;
        each.point = [&](const Vector3d& p) { return Vector3d(p + query.A.X_WB.p_WB); };
        return each.Of(answer);
      }));
  return mistakes;
}

std::vector<ContactMistake> MistakesWithQuestions() {
  std::vector<ContactMistake> mistakes;
  mistakes.push_back(OfShapes(
      "it takes the half extents of a box for its edges: its boxes are half as large",
      BoxTimes(0.5)));
  mistakes.push_back(OfShapes(
      "it takes the edges of a box for its half extents: its boxes are twice as large",
      BoxTimes(2)));
  mistakes.push_back(
      OfShapes("it takes a radius for a diameter: its round shapes are half as thick",
               RoundTimes{0.5, 1}));
  mistakes.push_back(
      OfShapes("it takes a diameter for a radius: its round shapes are twice as thick",
               RoundTimes{2, 1}));
  mistakes.push_back(
      OfShapes("it takes the half length for the length: its capsules, cylinders and "
               "cones are half "
               "as long",
               RoundTimes{1, 0.5}));
  mistakes.push_back(OfShapes(
      "it takes the length for the half length: its capsules, cylinders and cones are "
      "twice as long",
      RoundTimes{1, 2}));
  mistakes.push_back(OfShapes(
      "it takes the half length of a capsule with its caps; expected that of the segment",
      CapsuleLongerBy(-1)));
  mistakes.push_back(OfShapes(
      "it adds the caps to the half length of a capsule; expected that of the segment",
      CapsuleLongerBy(1)));
  mistakes.push_back(
      OfPoses("the axis of its capsules, cylinders and cones is y; expected z",
              AxisAlong(Vector3d::UnitY())));
  mistakes.push_back(
      OfPoses("the axis of its capsules, cylinders and cones is x; expected z",
              AxisAlong(Vector3d::UnitX())));
  mistakes.push_back(
      OfPoses("its cones point down; expected the apex at +z",
              [](const Body& body) -> std::optional<Pose> {
                if (!std::holds_alternative<Cone>(body.shape)) return std::nullopt;
                const Matrix3d turn = Vector3d(1, -1, -1).asDiagonal().toDenseMatrix();
                return Pose::FromMatrix(body.X_WB.p_WB, body.X_WB.R_WB * turn);
              }));
  mistakes.push_back(OfPoses(
      "it reads the quaternion w, x, y, z as x, y, z, w", Turned([](const Pose& pose) {
        const Quaterniond q = QuaternionOf(pose);
        return Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix();
      })));
  mistakes.push_back(OfPoses(
      "it gives its engine the quaternion as x, y, z, w, which reads it as w, x, y, z",
      Turned([](const Pose& pose) {
        const Quaterniond q = QuaternionOf(pose);
        return Quaterniond(q.x(), q.y(), q.z(), q.w()).toRotationMatrix();
      })));
  mistakes.push_back(
      OfPoses("it turns bodies by the inverse rotation",
              Turned([](const Pose& pose) { return Matrix3d(pose.R_WB.transpose()); })));
  mistakes.push_back(OfPoses("it does not turn bodies at all", Turned([](const Pose&) {
                               return Matrix3d(Matrix3d::Identity());
                             })));
  mistakes.push_back(OfPoses(
      "it takes the position for that of a corner or an end; expected that of the centre",
      CentreOff(1)));
  mistakes.push_back(OfPoses(
      "it takes the position for that of the apex or the upper end; expected the centre",
      CentreOff(-1)));
  mistakes.push_back(
      OfPoses("its cones are placed by their centre of mass, a quarter above the base; "
              "expected the "
              "middle of the axis",
              [](const Body& body) -> std::optional<Pose> {
                // The centre of mass is half a half height below the middle of the axis.
                if (!std::holds_alternative<Cone>(body.shape)) return std::nullopt;
                return CentreOff(0.5)(body);
              }));
  return mistakes;
}

}  // namespace

const std::vector<ContactMistake>& ContactMistakes() {
  static const std::vector<ContactMistake> kMistakes = [] {
    std::vector<ContactMistake> mistakes = MistakesWithAnswers();
    for (ContactMistake& mistake : MistakesWithQuestions())
      mistakes.push_back(std::move(mistake));
    return mistakes;
  }();
  return kMistakes;
}

}  // namespace touchstone
