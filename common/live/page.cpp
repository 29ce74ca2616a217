// What the page calls. One instance holds one figure. What it gives back are bytes in this module's memory,
// or calls of the imports.
#include <cmath>
#include <cstdio>

#include "nutshell/live/figure.hpp"
#include "studio.hpp"
#include "words.hpp"

#define EXPORT(name) __attribute__((used, export_name(#name))) name
#define IMPORT(name) __attribute__((import_module("page"), import_name(#name)))

extern "C" {
IMPORT(say) void page_say(const char* text, std::size_t length);
IMPORT(width) double page_width(const char* text, std::size_t length, double height, int bold);
IMPORT(now) double page_now();
}

// --- the part of the painter that differs in a page: its context, and the width of letters
namespace nutshell::picture {

struct Context::Handles {};
Context::Context() = default;
Context::~Context() = default;
void Context::use() {}
std::string Context::name() {
    return "WebGL2";
}

double text_width(const std::string& text, double height, Weight weight) {
    return page_width(text.data(), text.size(), height, weight == Weight::bold);
}

}  // namespace nutshell::picture

namespace nutshell::live {

namespace {

using Eigen::Vector3d;

struct Page {
    explicit Page(const Entry& entry) : figure(entry.make()), setting(figure->states().front().setting) {}
    picture::Studio studio;
    std::unique_ptr<Figure> figure;
    Setting setting;
    double owed = 0;                            ///< of the figure's time, to its next step
    bool between = false;                       ///< shown between the last two steps, as long as it runs
    double turned = 0, tilted = 0, nearer = 1;  ///< the camera, by the reader
    pic::Size size{};
};
std::unique_ptr<Page> page;

/// The figure's camera carried round its target by the reader's angles.
pic::Camera carried(pic::Camera camera) {
    const Vector3d up = camera.up.normalized();
    Vector3d arm = camera.eye - camera.target;
    if (page->turned != 0 || page->tilted != 0) {
        const double rise = std::atan2(arm.dot(up), (arm - up * arm.dot(up)).norm());
        page->tilted = std::min(std::max(rise + page->tilted, 0.03), 1.5) - rise;
        const Vector3d side = up.cross(arm).normalized();
        arm = Eigen::AngleAxisd(page->turned, up) * (Eigen::AngleAxisd(-page->tilted, side) * arm);
    }
    camera.eye = camera.target + arm * page->nearer;
    return camera;
}

pic::Camera camera() {
    return carried(page->figure->camera(page->size));
}

/// The line into the world behind a point of the picture [pixels].
Ray ray(double x, double y) {
    const pic::Camera from = camera();
    const Vector3d back = (from.eye - from.target).normalized(), right = from.up.cross(back).normalized(),
                   up = back.cross(right);
    const double tangent = 2 * std::tan(from.field_of_view / 2) / page->size.height;
    const Vector3d direction =
        (x - page->size.width / 2.0) * tangent * right + (page->size.height / 2.0 - y) * tangent * up - back;
    return {from.eye, direction.normalized()};
}

// --- answers, as JSON

std::string json(double value) {
    if (!std::isfinite(value)) return "null";
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}
std::string json(const std::string& words) {
    std::string out = "\"";
    for (const char c : words) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n')
            out += "\\n";
        else
            out += c;
    }
    return out + "\"";
}
std::string json(const std::vector<double>& values) {
    std::string out = "[";
    for (const double value : values) out += (out.size() > 1 ? "," : "") + json(value);
    return out + "]";
}
template <class Things, class One>
std::string list(const Things& things, const One& one) {
    std::string out = "[";
    for (const auto& thing : things) out += (out.size() > 1 ? ",{" : "{") + one(thing) + "}";
    return out + "]";
}
std::string colours(const pic::Colour& colour) {
    return "\"light\":" + json(web(colour, pic::Theme::light)) +
           ",\"dark\":" + json(web(colour, pic::Theme::dark));
}

std::string sliders() {
    return list(page->figure->sliders(), [](const Slider& s) {
        return "\"name\":" + json(s.name) + ",\"unit\":" + json(s.unit) + ",\"least\":" + json(s.least) +
               ",\"most\":" + json(s.most) + ",\"start\":" + json(s.start) +
               ",\"logarithmic\":" + (s.logarithmic ? "true" : "false") +
               ",\"whole\":" + (s.whole ? "true" : "false") + ",\"mark\":" + json(s.mark) +
               ",\"words\":" + json(s.mark_words);
    });
}

void say(const std::string& text) {
    page_say(text.data(), text.size());
}

void begin() {
    page->figure->begin(page->setting);
    page->owed = 0, page->between = false;
}

}  // namespace

extern "C" {

/// The names of all figures.
void EXPORT(names)() {
    std::string out = "[";
    for (const Entry* entry : entries()) out += (out.size() > 1 ? "," : "") + json(std::string(entry->name));
    say(out + "]");
}

/// Makes figure number `index`, at the beginning of its first state.
void EXPORT(make)(int index) {
    page = std::make_unique<Page>(*entries().at(std::size_t(index)));
    begin();
}

/// Its controls.
void EXPORT(controls)() {
    const Figure& figure = *page->figure;
    const pic::Size size = figure.size();
    say("{\"width\":" + json(size.width) + ",\"height\":" + json(size.height) + ",\"choices\":" +
        list(figure.choices(),
             [](const Choice& c) {
                 return "\"key\":" + json(c.key) + ",\"name\":" + json(c.name) + "," +
                        colours(pic::hex(shades_of(c.look.family)));
             }) +
        ",\"sliders\":" + sliders() + ",\"states\":" +
        list(figure.states(),
             [](const State& s) {
                 return "\"key\":" + json(s.key) + ",\"words\":" + json(s.words) +
                        ",\"choice\":" + json(double(s.setting.choice)) +
                        ",\"values\":" + json(s.setting.values) +
                        ",\"time\":" + json(s.instants.empty() ? s.time : s.instants.front());
             }) +
        "}");
}

/// Its sliders as they are now: marks follow the setting.
void EXPORT(marks)() {
    say(sliders());
}

void EXPORT(choose)(int choice) {
    page->setting.choice = choice;
}
void EXPORT(set)(int slider, double value) {
    page->setting.values.at(std::size_t(slider)) = value;
}
/// The setting in force. @param again from the beginning
void EXPORT(apply)(int again) {
    if (again)
        begin();
    else
        page->figure->change(page->setting);
}
/// The setting in force, at this moment.
void EXPORT(go)(double time) {
    go_to(*page->figure, page->setting, time);
    page->owed = 0, page->between = false;
}

/// Lets `seconds` of the reader's time pass. Steps that do not fit into 25 ms are dropped: it slows down
/// instead of freezing.
void EXPORT(advance)(double seconds) {
    Figure& figure = *page->figure;
    const double begun = page_now();
    page->owed += seconds * figure.pace(), page->between = true;
    while (page->owed >= figure.step_size() && figure.ended().empty()) {
        page->owed -= figure.step_size();
        figure.step();
        if (page_now() - begun > 25) page->owed = std::min(page->owed, figure.step_size());
    }
}
void EXPORT(step)() {
    if (page->figure->ended().empty()) page->figure->step();
    page->owed = 0, page->between = false;
}

/// Its numbers, its time and why it ended.
void EXPORT(numbers)() {
    const Figure& figure = *page->figure;
    say("{\"time\":" + json(figure.time()) + ",\"ended\":" + json(figure.ended()) + ",\"numbers\":" +
        list(figure.numbers(),
             [](const Number& n) {
                 const char* traces[] = {"", "linear", "logarithmic"};
                 return "\"name\":" + json(n.name) + ",\"value\":" + json(n.value) +
                        ",\"unit\":" + json(n.unit) + ",\"trace\":" + json(std::string(traces[int(n.trace)]));
             }) +
        "}");
}

/// Every number of the physics, and how far they may be from the native program's.
void EXPORT(state)() {
    say("{\"tolerance\":" + json(page->figure->page_tolerance()) +
        ",\"state\":" + json(page->figure->state()) + "}");
}

void EXPORT(turn)(double right, double up, double nearer) {
    page->turned -= right, page->tilted += up;
    page->nearer = std::min(std::max(page->nearer * nearer, 0.3), 3.0);
}
int EXPORT(grab)(double x, double y) {
    return page->figure->grab(ray(x, y));
}
void EXPORT(drag)(double x, double y) {
    page->figure->drag(ray(x, y));
}
void EXPORT(release)() {
    page->figure->release();
}

/// Paints on the context's own frame. @param width, height as shown [CSS pixels]  @param drawn_width  the
/// picture's own, less than `width` where drawing is slow  @param samples of one pixel along each side
void EXPORT(draw)(int width, int height, int drawn_width, int samples, int dark, int with_words) {
    page->size = {width, height};
    const double part = page->between ? page->owed / page->figure->step_size() : 1;  // of the last step
    pic::Drawing drawing = page->figure->drawing(std::min(part, 1.0));
    drawing.theme(dark ? pic::Theme::dark : pic::Theme::light);
    const pic::Camera from = camera();
    const int drawn_height = std::max(1, int(std::lround(double(drawn_width) * height / width)));
    const pic::Size drawn{drawn_width, drawn_height};
    picture::draw(page->studio, drawing, from, drawn, {.samples = samples, .shadow_map = 1024}, [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, drawn_width * samples, drawn_height * samples);
    });
    if (!with_words) return;
    say(list(place_words(drawing, from, page->size), [](const picture::Line& line) {
        return "\"text\":" + json(line.text) + ",\"left\":" + json(line.left) +
               ",\"right\":" + json(line.right) + ",\"baseline\":" + json(line.baseline) +
               ",\"height\":" + json(line.height) + ",\"ends\":" + (line.ends ? "true" : "false") +
               ",\"bold\":" + (line.weight == picture::Weight::bold ? "true" : "false") + "," +
               colours(line.ink);
    }));
}

}  // extern "C"

}  // namespace nutshell::live
