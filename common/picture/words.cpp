#include "words.hpp"

#include <stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace nutshell::picture {

namespace {

class Font {
  public:
    explicit Font(const char* file) {
        std::ifstream in(file, std::ios::binary);
        data_.assign(std::istreambuf_iterator<char>(in), {});
        const auto* bytes = reinterpret_cast<const unsigned char*>(data_.data());
        if (data_.empty() || !stbtt_InitFont(&info_, bytes, stbtt_GetFontOffsetForIndex(bytes, 0))) {
            throw NoGraphics("the font " + std::string(file) +
                             " is missing or broken (Debian package fonts-lato)");
        }
    }
    const stbtt_fontinfo* info() const { return &info_; }

  private:
    std::vector<char> data_;
    stbtt_fontinfo info_{};
};

const Font& font(Weight weight) {
    static const Font regular(PICTURE_FONT_REGULAR), bold(PICTURE_FONT_BOLD);
    return weight == Weight::bold ? bold : regular;
}

/// The code points of UTF-8 text; what is not UTF-8 becomes a question mark.
std::vector<int> code_points(const std::string& text) {
    std::vector<int> out;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i++]);
        const int more = lead < 0x80 ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : -1;
        int code = more <= 0 ? lead : lead & (0x3F >> more);
        bool good = more >= 0;
        for (int k = 0; k < more; ++k) {
            const int next = i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
            good = good && (next & 0xC0) == 0x80;
            if (!good) break;
            code = (code << 6) | (next & 0x3F);
            ++i;
        }
        out.push_back(good ? code : '?');
    }
    return out;
}

/// Calls visit(glyph, x) for every glyph, x in pixels from the start; returns the text's width.
template <class Visit>
double lay_out(const std::string& text, double height, const Font& font, Visit visit) {
    const double scale = double(stbtt_ScaleForMappingEmToPixels(font.info(), float(height)));
    double x = 0;
    int previous = 0;
    for (int code : code_points(text)) {
        const int glyph = stbtt_FindGlyphIndex(font.info(), code);
        if (previous) x += scale * stbtt_GetGlyphKernAdvance(font.info(), previous, glyph);
        visit(glyph, x);
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(font.info(), glyph, &advance, &bearing);
        x += scale * advance;
        previous = glyph;
    }
    return x;
}

/// How much of each pixel is covered, in a rectangle of the picture.
struct Coverage {
    int left, top, width, height;
    std::vector<float> share;

    Coverage(int l, int t, int w, int h)
        : left(l), top(t), width(w), height(h), share(std::size_t(w) * std::size_t(h)) {}
    float& at(int x, int y) { return share[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    float get(int x, int y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return 0;
        return share[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

Coverage cover(const std::string& text, double x, double baseline, double height, const Font& font,
               int border) {
    const double width = lay_out(text, height, font, [](int, double) {});
    const int left = int(std::floor(x)) - border, top = int(std::floor(baseline - height)) - border;
    Coverage out(left, top, int(std::ceil(width)) + 2 * border + 2,
                 int(std::ceil(1.4 * height)) + 2 * border);
    const float scale = stbtt_ScaleForMappingEmToPixels(font.info(), float(height));
    lay_out(text, height, font, [&](int glyph, double offset) {
        const double gx = x + offset, gy = baseline;
        const float shift_x = float(gx - std::floor(gx)), shift_y = float(gy - std::floor(gy));
        int w = 0, h = 0, dx = 0, dy = 0;
        unsigned char* bitmap = stbtt_GetGlyphBitmapSubpixel(font.info(), scale, scale, shift_x, shift_y,
                                                             glyph, &w, &h, &dx, &dy);
        for (int j = 0; j < h; ++j) {
            for (int i = 0; i < w; ++i) {
                const int px = int(std::floor(gx)) + dx + i - left, py = int(std::floor(gy)) + dy + j - top;
                if (px < 0 || py < 0 || px >= out.width || py >= out.height) continue;
                out.at(px, py) = std::min(1.0F, out.at(px, py) + float(bitmap[j * w + i]) / 255.0F);
            }
        }
        stbtt_FreeBitmap(bitmap, nullptr);
    });
    return out;
}

void blend(Image& image, const Coverage& coverage, const Colour& colour, float opacity) {
    for (int j = 0; j < coverage.height; ++j) {
        for (int i = 0; i < coverage.width; ++i) {
            const int x = coverage.left + i, y = coverage.top + j;
            const float share = opacity * coverage.get(i, j);
            if (share <= 0 || x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
            std::uint8_t* pixel =
                &image.rgb[3 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
            const float channel[] = {colour.red, colour.green, colour.blue};
            for (int c = 0; c < 3; ++c) {
                pixel[c] =
                    std::uint8_t(std::lround(float(pixel[c]) * (1 - share) + 255 * channel[c] * share));
            }
        }
    }
}

/// The text grown by a radius, with a soft edge.
Coverage grown(const Coverage& text, double radius) {
    Coverage out = text;
    const int reach = int(std::ceil(radius));
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            float most = 0;
            for (int j = -reach; j <= reach; ++j) {
                for (int i = -reach; i <= reach; ++i) {
                    const float fade = float(std::clamp(radius + 0.5 - std::hypot(i, j), 0.0, 1.0));
                    most = std::max(most, fade * text.get(x + i, y + j));
                }
            }
            out.at(x, y) = most;
        }
    }
    return out;
}

}  // namespace

double text_width(const std::string& text, double height, Weight weight) {
    return lay_out(text, height, font(weight), [](int, double) {});
}

void write_words(Image& image, const std::vector<Line>& lines, Theme theme) {
    for (const Line& line : lines) {
        const double halo_radius = 0.16 * line.height;
        const Coverage letters = cover(line.text, line.left, line.baseline, line.height, font(line.weight),
                                       int(std::ceil(halo_radius)) + 1);
        blend(image, grown(letters, halo_radius), palette::paper.on(theme), 0.72F);
        blend(image, letters, line.ink.on(theme), 1);
    }
}

}  // namespace nutshell::picture
