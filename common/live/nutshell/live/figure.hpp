// A figure that moves: one value that holds a scene, its methods, what it draws at a moment, its controls and
// its numbers. The chapter's program draws its still from it, the page its live form: the two cannot differ.
// One file of a chapter is one figure, live/NAME.cpp; it ends with
//   const live::Entry entry{"NAME", [] { return std::unique_ptr<live::Figure>(new MyFigure); }};
#pragma once
#include <memory>
#include <nutshell/look.hpp>
#include <nutshell/picture/camera.hpp>
#include <nutshell/picture/drawing.hpp>
#include <string>
#include <vector>

namespace nutshell::live {

namespace pic = picture;

/// One of several: a method, or a way of doing it. Shown as a button in its family's colour.
struct Choice {
    std::string key{};   ///< in addresses and file names: "semi_implicit_euler"
    std::string name{};  ///< on the button
    Look look{};
};

/// A number in the reader's hand. A mark is a place worth seeing on its way: a predicted limit.
struct Slider {
    std::string name{}, unit{};
    double least = 0, most = 1, start = 0;
    bool logarithmic = true;
    double mark = 0;  ///< 0: none; it may change with the method and the other sliders
    std::string mark_words{};
    bool whole = false;  ///< takes whole numbers only: boxes, steps a second
};

/// How the controls stand.
struct Setting {
    int choice = 0;
    std::vector<double> values{};  ///< one for each slider
};

/// A place that the text speaks of: a setting and a moment. The first one is the figure's still.
struct State {
    std::string key{};    ///< the page's link says it; its still is NAME_KEY, the first one's NAME
    std::string words{};  ///< over its still and on its link, in a few words
    Setting setting{};
    double time = 0;                 ///< of the still, on the figure's clock
    bool drawn = false;              ///< has a still, as the first one always has
    std::vector<double> instants{};  ///< its still is a strip of these moments, 5 to 7 of them
};

/// A running number.
struct Number {
    std::string name{};
    double value = 0;
    std::string unit{};
    enum class Trace { none, linear, logarithmic } trace = Trace::none;  ///< also drawn against time
};

/// The pointer as a line into the world.
struct Ray {
    Eigen::Vector3d eye, direction;  ///< [m], unit vector
};

/// Time runs on the figure's own clock in steps of step_size(); the page and the still keep the accumulator.
class Figure {
  public:
    virtual ~Figure() = default;

    // --- what the reader can change
    virtual std::vector<Choice> choices() const { return {}; }
    virtual std::vector<Slider> sliders() const { return {}; }
    /// At least one. @see State
    virtual std::vector<State> states() const = 0;

    // --- what happens
    /// Takes the setting and begins again at time 0. @throws std::invalid_argument for numbers it cannot bear
    virtual void begin(const Setting& setting) = 0;
    /// Takes the setting and goes on if it can. @throws as begin
    virtual void change(const Setting& setting) { begin(setting); }
    virtual double time() const = 0;           ///< on its own clock
    virtual double step_size() const = 0;      ///< that the next step() adds to time(), > 0
    virtual double pace() const { return 1; }  ///< how much of its time passes in a second of the reader's
    virtual void step() = 0;
    /// Why there is nothing more to see, in words ("It flew apart after 0.4 s."); empty: it goes on.
    virtual std::string ended() const { return {}; }

    // --- what is seen
    /// @param part of the last step that is shown, 0 to 1: 1 is the newest state. What cannot be drawn
    /// between two steps takes no notice.
    virtual pic::Drawing drawing(double part) const = 0;
    virtual pic::Size size() const { return {}; }          ///< of the still; the page keeps its shape
    virtual pic::Camera camera(pic::Size size) const = 0;  ///< before the reader turns it
    virtual std::vector<Number> numbers() const = 0;
    /// Every number of the physics: compared between the program and the page.
    virtual std::vector<double> state() const = 0;
    /// How far the two may be apart after 1000 steps, relative to the largest number. 0, the same bits, for
    /// figures of
    /// + - * / and sqrt; sin, exp and their like differ between the two C libraries in the last digit.
    virtual double page_tolerance() const { return 0; }

    // --- the reader's hand
    /// @return whether something is there to be held; then drag and release follow
    virtual bool grab(const Ray&) { return false; }
    virtual void drag(const Ray&) {}
    virtual void release() {}
};

/// Registers a figure under its name; one at the end of each live/NAME.cpp.
struct Entry {
    using Make = std::unique_ptr<Figure> (*)();
    Entry(const char* name, Make make);
    const char* name;
    Make make;
};

/// All that this program holds, by name.
std::vector<const Entry*> entries();

/// The setting with every slider at its start and the first choice.
Setting first_setting(const Figure& figure);

/// Puts the figure into a state: begins with its setting and makes steps up to its moment (or the end).
void go_to(Figure& figure, const Setting& setting, double time);

}  // namespace nutshell::live
