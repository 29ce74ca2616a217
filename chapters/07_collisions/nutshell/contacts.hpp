// Chapter 7 · Contacts: where two shapes touch, or are about to, and along which normal.
#pragma once
#include <nutshell/hull_contacts.hpp>
#include <nutshell/time_of_impact.hpp>

namespace nutshell {

// [plane_contacts]
/// A wall `plane` and a shape in front of it. The wall is the contact's body a.
inline void find_contacts(const Plane& plane, const Sphere& sphere, const Body& body,
                          double margin, std::vector<Contact>& found) {
    const double gap = distance_to(plane, body.position) - sphere.radius;
    if (gap >= margin) return;
    const Vector3 middle = body.position - (sphere.radius + gap / 2) * plane.normal;
    found.push_back({middle, plane.normal, gap, 0});
}

/// A box touches a plane with its corners.
inline void find_contacts(const Plane& plane, const Box& box, const Body& body, double margin,
                          std::vector<Contact>& found) {
    if (distance_to(plane, body.position) - reach(box) >= margin) return;
    const Matrix3 axes = rotation_matrix(body.orientation) * box.half.asDiagonal();
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3 point = body.position + axes * corner_signs(corner);
        const double gap = distance_to(plane, point);
        if (gap < margin)
            found.push_back({point - gap / 2 * plane.normal, plane.normal, gap, corner});
    }
}

/// And so does a hull.
inline void find_contacts(const Plane& plane, const Hull& hull, const Body& body, double margin,
                          std::vector<Contact>& found) {
    const Matrix3 axes = rotation_matrix(body.orientation);
    int number = 0;
    for (const Vector3& corner : hull.form->corners) {
        const Vector3 point = body.position + axes * corner;
        const double gap = distance_to(plane, point);
        if (gap < margin)
            found.push_back({point - gap / 2 * plane.normal, plane.normal, gap, number});
        ++number;
    }
}

/// A rod touches it with its ends.
inline void find_contacts(const Plane& plane, const Capsule& rod, const Body& body, double margin,
                          std::vector<Contact>& found) {
    const Vector3 arm = rotate(body.orientation, {0, rod.half_length, 0});
    for (const int end : {-1, 1}) {
        const Vector3 centre = body.position + end * arm;
        const double gap = distance_to(plane, centre) - rod.radius;
        if (gap < margin)
            found.push_back({centre - (rod.radius + gap / 2) * plane.normal, plane.normal, gap,
                             (end + 1) / 2});
    }
}
// [/plane_contacts]

// [sphere_contacts]
/// Two spheres touch on the line between their centres. Where the centres coincide there is no
/// such line: the normal is then up.
inline void find_contacts(const Sphere& s, const Body& a, const Sphere& t, const Body& b,
                          double margin, std::vector<Contact>& found) {
    const Vector3 between = b.position - a.position;
    const double square = between.squaredNorm(), near = s.radius + t.radius + margin;
    if (square >= near * near) return;
    const double distance = std::sqrt(square), gap = distance - s.radius - t.radius;
    const Vector3 n = distance > 0 ? Vector3(between / distance) : Vector3(0, 1, 0);
    found.push_back({a.position + (s.radius + gap / 2) * n, n, gap, 0});
}

/// A sphere touches a box at the box's point nearest to its centre; a centre inside the box, at
/// the nearest face.
inline void find_contacts(const Box& box, const Body& a, const Sphere& sphere, const Body& b,
                          double margin, std::vector<Contact>& found) {
    const double near = reach(box) + sphere.radius + margin;
    if ((b.position - a.position).squaredNorm() >= near * near) return;
    const Vector3 centre = rotate(inverse(a.orientation), b.position - a.position);
    Vector3 nearest = centre.cwiseMax(-box.half).cwiseMin(box.half), n = centre - nearest;
    double distance = n.norm();
    if (distance > 0) {
        n /= distance;
    } else {  // inside: the face that is the least way off
        int axis = 0;
        distance = -(box.half - centre.cwiseAbs()).minCoeff(&axis);
        n = std::copysign(1.0, centre[axis]) * Vector3::Unit(axis);
        nearest = centre - distance * n;
    }
    const double gap = distance - sphere.radius;
    if (gap >= margin) return;
    found.push_back({a.position + rotate(a.orientation, nearest + gap / 2 * n),
                     rotate(a.orientation, n), gap, 0});
}
inline void find_contacts(const Sphere& sphere, const Body& a, const Box& box, const Body& b,
                          double margin, std::vector<Contact>& found) {
    const std::size_t before = found.size();
    find_contacts(box, b, sphere, a, margin, found);
    for (std::size_t i = before; i < found.size(); ++i) found[i].normal = -found[i].normal;
}
// [/sphere_contacts]

// [hull_and_sphere]
/// The point of a hull's face nearest to `point` [m], body axes: straight below it, or on a side.
inline Vector3 nearest_on_face(const Polyhedron& form, std::size_t f, const Vector3& point) {
    const auto& face = form.faces[f];
    const Vector3 &n = form.normals[f], foot = point - n.dot(point - form.corners[face[0]]) * n;
    Vector3 nearest = foot;
    bool inside = true;
    double least = immovable;
    for (std::size_t k = 0; k < face.size(); ++k) {
        const Vector3 &p = form.corners[face[k]],
                      side = form.corners[face[(k + 1) % face.size()]] - p;
        const double part = side.dot(foot - p) / side.squaredNorm();
        const Vector3 on_side = p + std::clamp(part, 0.0, 1.0) * side;
        inside = inside && side.cross(n).dot(foot - p) <= 0;
        if ((foot - on_side).norm() < least) least = (foot - on_side).norm(), nearest = on_side;
    }
    return inside ? foot : nearest;
}

/// A sphere touches a hull at the hull's point nearest to its centre; a centre inside the hull,
/// or nearer than a billionth of its reach, at the nearest face.
inline void find_contacts(const Hull& hull, const Body& a, const Sphere& sphere, const Body& b,
                          double margin, std::vector<Contact>& found) {
    const Polyhedron& form = *hull.form;
    const Vector3 centre = rotate(inverse(a.orientation), b.position - a.position);
    double distance = -immovable;
    Vector3 n = Vector3::Zero();
    for (std::size_t f = 0; f < form.faces.size(); ++f) {
        const double above = form.normals[f].dot(centre - form.corners[form.faces[f][0]]);
        if (above > distance) distance = above, n = form.normals[f];
    }
    if (distance > 1e-9 * form.reach && distance < sphere.radius + margin) {
        Vector3 way = Vector3::Constant(immovable);
        for (std::size_t f = 0; f < form.faces.size(); ++f) {
            if (form.normals[f].dot(centre - form.corners[form.faces[f][0]]) <= 0) continue;
            const Vector3 from = centre - nearest_on_face(form, f, centre);
            if (from.squaredNorm() < way.squaredNorm()) way = from;
        }
        distance = way.norm(), n = way / distance;
    }
    const double gap = distance - sphere.radius;
    if (gap >= margin) return;
    const Vector3 middle = centre - (distance - gap / 2) * n;
    found.push_back(
        {a.position + rotate(a.orientation, middle), rotate(a.orientation, n), gap, 0});
}
inline void find_contacts(const Sphere& sphere, const Body& a, const Hull& hull, const Body& b,
                          double margin, std::vector<Contact>& found) {
    const std::size_t before = found.size();
    find_contacts(hull, b, sphere, a, margin, found);
    for (std::size_t i = before; i < found.size(); ++i) found[i].normal = -found[i].normal;
}
// [/hull_and_sphere]

/// Two hulls, or a hull and a box.
inline void find_contacts(const Hull& s, const Body& a, const Hull& t, const Body& b,
                          double margin, std::vector<Contact>& found) {
    find_contacts(placed(s, a), placed(t, b), margin, found);
}
inline void find_contacts(const Box& s, const Body& a, const Hull& t, const Body& b,
                          double margin, std::vector<Contact>& found) {
    find_contacts(placed(s, a), placed(t, b), margin, found);
}
inline void find_contacts(const Hull& s, const Body& a, const Box& t, const Body& b,
                          double margin, std::vector<Contact>& found) {
    find_contacts(placed(s, a), placed(t, b), margin, found);
}

/// Rods touch walls only: the course has no scene in which they touch each other.
template <class A, class B>
void find_contacts(const A&, const Body&, const B&, const Body&, double, std::vector<Contact>&) {
    throw std::invalid_argument(
        "find_contacts: rods (capsules) touch planes only; use boxes or spheres here");
}

// [any_contacts]
/// All contacts of two shapes whose gap is below `margin` [m], added to `found`.
inline void find_contacts(const Shape& s, const Body& a, const Shape& t, const Body& b,
                          double margin, std::vector<Contact>& found) {
    std::visit([&](const auto& x, const auto& y) { find_contacts(x, a, y, b, margin, found); }, s,
               t);
}
inline void find_contacts(const Plane& plane, const Shape& shape, const Body& body, double margin,
                          std::vector<Contact>& found) {
    std::visit([&](const auto& s) { find_contacts(plane, s, body, margin, found); }, shape);
}
// [/any_contacts]

/// When a body comes to a plane, and how it then lies.
struct Arrival {
    double time;  ///< [s]
    Body body;
};

// [advancement]
/// How far [m] a shape is in front of a plane: its nearest point.
inline double gap_to(const Plane& plane, const Shape& shape, const Body& body) {
    std::vector<Contact> found;
    find_contacts(plane, shape, body, immovable, found);
    double gap = immovable;
    for (const Contact& contact : found) gap = std::min(gap, contact.separation);
    return gap;
}

/// When [s] a shape that flies and turns freely comes within `tolerance` [m] of a plane, up to
/// `duration`: conservative advancement. No point of it comes nearer faster than the centre does,
/// plus |L|/I, the fastest it can ever turn, times its reach: so it may fly gap over that speed
/// and cannot have touched. Exact but for `tolerance` where the free rotation is: for bodies with
/// two equal moments.
/// @return the time and the body then; nothing if it stays away
/// @throws std::invalid_argument if the tolerance is not greater than zero
inline std::optional<Arrival> time_of_impact(const Shape& shape, Body body,
                                             const Vector3& acceleration, const Plane& plane,
                                             double duration, double tolerance) {
    require_positive(tolerance, "time_of_impact: the tolerance [m]");
    const auto weight = [&](const Body& b, double) {
        return Wrench{b.mass * acceleration, {0, 0, 0}};
    };
    const double turning = body.angular_momentum.norm() / body.inertia.minCoeff() * reach(shape);
    const double fall = std::max(0.0, -plane.normal.dot(acceleration));
    for (double t = 0;;) {
        const double gap = gap_to(plane, shape, body);
        if (gap <= tolerance) return Arrival{t, body};
        const double speed = std::max(0.0, -plane.normal.dot(velocity(body))) + turning;
        if (speed == 0 && fall == 0) return {};
        // gap = speed s + fall s^2/2 at most: the longest s that is safe
        const double safe = 2 * gap / (speed + std::sqrt(speed * speed + 2 * fall * gap));
        if (!(t + safe <= duration)) return {};
        body = verlet(body, weight, t, safe);
        t += safe;
    }
}
// [/advancement]

}  // namespace nutshell
