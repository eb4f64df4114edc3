/// \file
/// Lets a picture that takes long be made in parts of some milliseconds, so that the interface's thread can
/// do other things in between. Every part goes through the whole sequence of draws, which sets up the state
/// that each needs, but issues only the draws whose turn it is.
#pragma once

#include "core/base/stopwatch.h"
#include "widgets/view/render/shader_program.h"
#include <QSize>
#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>

namespace ramure {

/// Outside begin() and end() all draws are issued at once.
class PictureParts
{
public:
    /// The passes that draw into one framebuffer, in their order.
    enum class Pass : std::uint8_t { Occlusion, Shadow, NearShadow, Picture };

    explicit PictureParts(Gl& gl)
        : m_gl(gl)
    {
    }
    /// The next part starts and takes about \p ms, but makes at least one draw. Infinity: all of them.
    void begin(double ms)
    {
        m_isActive = true;
        m_isLeft = m_isSpent = false;
        m_ms = ms;
        m_watch.restart();
    }
    /// \returns whether nothing of the picture is left to be drawn.
    bool end()
    {
        m_isActive = false;
        return !m_isLeft;
    }
    [[nodiscard]] bool isActive() const { return m_isActive; }
    /// False where draws of the part that runs had to be left for another one.
    [[nodiscard]] bool isWhole() const { return !m_isLeft; }
    /// The next part is the first of a new picture.
    void restart()
    {
        m_next = {};
        m_isLeft = false;
    }
    /// To be called before the draws of a pass. \param size of its framebuffer, in pixels
    /// \returns false where all of its draws are made already, or none is due in this part.
    bool enter(Pass pass, QSize size)
    {
        m_size = size;
        m_here = {pass, 0, 0};
        if (!m_isActive)
            return true;
        if (!m_isLeft)
            m_next = std::max(m_next, m_here);
        m_isLeft = m_isLeft || (m_isSpent && m_next.pass == pass);
        return !m_isLeft && m_next.pass == pass;
    }
    /// Nothing of the pass is drawn yet: its framebuffer has to be cleared.
    [[nodiscard]] bool isFirst() const { return !m_isActive || m_next == Place{m_here.pass, 0, 0}; }

    /// A draw of \p count things that can be made for some of them at a time.
    /// \param draw (int first, int count)
    template <class Draw> void share(int count, const Draw& draw)
    {
        constexpr double goodMs = 10.0;
        if (isAtOnce())
            return draw(0, count);
        const Place here{m_here.pass, m_here.draw++, 0};
        if (m_isLeft || m_next.draw > here.draw)
            return;
        m_isWithin = true;
        for (int size = std::max(1, count / 64); m_next.first < count;) {
            m_isLeft = m_isSpent;
            if (m_isLeft)
                break;
            const Stopwatch watch;
            size = std::min(size, count - m_next.first);
            draw(m_next.first, size);
            m_gl.glFinish(); // drivers only note down what is to be drawn
            m_next.first += size;
            m_isSpent = m_watch.elapsed().wallMs >= m_ms;
            const double change = goodMs / std::max(watch.elapsed().wallMs, 1e-3);
            size = std::max(1, int(size * std::clamp(change, 0.1, 8.0)));
        }
        m_isWithin = false;
        if (!m_isLeft)
            m_next = {here.pass, here.draw + 1, 0};
    }
    /// A draw that can be made for some rows of the framebuffer at a time.
    template <class Draw> void rows(const Draw& draw)
    {
        if (isAtOnce())
            return draw();
        share(m_size.height(), [&](int first, int count) {
            m_gl.glEnable(GL_SCISSOR_TEST);
            m_gl.glScissor(0, first, m_size.width(), count);
            draw();
            m_gl.glDisable(GL_SCISSOR_TEST);
        });
    }

private:
    struct Place
    {
        Pass pass = Pass::Occlusion;
        int draw = 0;
        int first = 0; ///< first index of the draw's own range
        auto operator<=>(const Place&) const = default;
    };

    [[nodiscard]] bool isAtOnce() const { return !m_isActive || m_isWithin || std::isinf(m_ms); }

    Gl& m_gl;
    bool m_isActive = false;
    bool m_isLeft = false;
    bool m_isSpent = false;  ///< the time of this part
    bool m_isWithin = false; ///< a draw that is made of others
    double m_ms = 0.0;
    Stopwatch m_watch;
    QSize m_size;
    Place m_here;
    Place m_next; ///< all before it is drawn
};

} // namespace ramure
