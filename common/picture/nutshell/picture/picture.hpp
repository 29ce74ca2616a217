// Pictures of scenes, drawn off-screen: no display, no GPU.
//
//     namespace pic = nutshell::picture;
//     pic::Drawing drawing;                                          // has ground, sky and sun already
//     drawing.add(pic::Ball{.centre = {0, 1, 0}, .radius = 0.2, .colour = pic::palette::symplectic});
//     drawing.add(pic::Arrow{.from = {0, 1, 0}, .vector = {1, 0.5, 0}, .label = "v"});
//     pic::add(drawing, pic::Stroboscope{.computed = euler, .exact = exact, .radius = 0.2,
//                                        .colour = pic::palette::explicit_euler});
//     drawing.title("Euler throws too far").caption("dt = 0.1 s; dashed: exact");
//     pic::Camera camera = pic::fit(drawing, {0.3, 0.4, 1});         // from the front, a little right and
//     above pic::save("out/throw.png", {.command = "01_newton", .scene = "throw", .method = "Euler", .dt =
//     "0.1 s",
//                                 .numbers = {{"error", 1.5, "m"}}}, [&] { return pic::render(drawing,
//                                 camera); });
//
// World frame: right-handed, y up, lengths in metres (or any one unit; say which by Ground::unit).
// Widths of lines and heights of letters are pixels of a picture 960 wide and scale with the picture.
// Where graphics are missing, `save` writes the note with its reason and the program goes on; see image.hpp.
#pragma once
#include "nutshell/picture/camera.hpp"
#include "nutshell/picture/colour.hpp"
#include "nutshell/picture/drawing.hpp"
#include "nutshell/picture/image.hpp"
#include "nutshell/picture/render.hpp"
#include "nutshell/picture/save.hpp"
#include "nutshell/picture/sheet.hpp"
