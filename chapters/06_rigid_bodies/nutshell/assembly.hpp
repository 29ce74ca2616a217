// Chapter 6 · Assembly: one rigid body out of several.
#pragma once
#include <nutshell/inertia.hpp>
#include <vector>

namespace nutshell {

// [part]
/// A part and where it is put: its own axes turned by `rotation`, their origin moved to `place`.
struct Part {
    MassProperties body;
    Vector3 place = Vector3::Zero();         ///< [m], in the axes of the whole
    Matrix3 rotation = Matrix3::Identity();  ///< from the part's axes to those of the whole
};

/// A uniform solid with its centre at `place`.
inline Part solid(double mass, const Vector3& moments, const Vector3& place,
                  const Matrix3& rotation = Matrix3::Identity()) {
    return {{mass, Vector3::Zero(), moments.asDiagonal()}, place, rotation};
}
// [/part]

// [assemble]
/// Mass, centre and inertia of parts that are one rigid body: masses add up, the centre is their
/// mean, each inertia is turned into common axes and moved to the common centre. Source: eqs.
/// (60)-(63), (62*). @throws std::invalid_argument if there is no part, or a mass is not positive
inline MassProperties assemble(std::span<const Part> parts) {
    require(!parts.empty(), "assemble: nothing to assemble");
    for (const Part& part : parts)
        require_positive(part.body.mass, "assemble: the mass of a part [kg]");
    // exercise 6.6
    MassProperties whole;
    const auto centre_of = [](const Part& part) -> Vector3 {
        return part.rotation * part.body.centre + part.place;
    };
    for (const Part& part : parts) {
        whole.mass += part.body.mass;
        whole.centre += part.body.mass * centre_of(part);
    }
    whole.centre /= whole.mass;
    for (const Part& part : parts)
        whole.inertia += in_world(part.body.inertia, part.rotation) +
                         parallel_axis(part.body.mass, centre_of(part) - whole.centre);
    return whole;
    // end 6.6
}
// [/assemble]

}  // namespace nutshell
