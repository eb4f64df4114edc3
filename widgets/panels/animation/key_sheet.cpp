#include "widgets/panels/animation/key_sheet.h"

#include "widgets/base/theme/theme.h"
#include "widgets/base/timeline_ruler.h"
#include "widgets/panels/animation/key_texts.h"
#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double keySide = 10.0;
constexpr double leastGap = 4.0; ///< keys closer than this are one bar

} // namespace

KeySheet::KeySheet(KeyModel* model, KeyCommands* commands, TimelineRuler* ruler, QScrollBar* scroll,
                   QWidget* parent)
    : KeyRowsView(model, scroll, parent)
    , m_commands(commands)
    , m_ruler(ruler)
{
    setObjectName(QStringLiteral("keySheet"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Dope sheet"));
    m_edgeScroll.setInterval(30);
    connect(&m_edgeScroll, &QTimer::timeout, this, [this] {
        const double beyond = m_at.x() < 0.0 ? m_at.x() : std::max(0.0, m_at.x() - width());
        const double frames = 0.15 * (m_ruler->framesAt(beyond) - m_ruler->framesAt(0.0));
        m_ruler->scrollBy(frames);
        dragTo(m_at, {});
    });
    connect(ruler, &TimelineRuler::viewChanged, this, qOverload<>(&QWidget::update));
    connect(model, &KeyModel::rowsChanged, this, [this] {
        m_row = rowOfCurrent();
        if (m_drag != Drag::None)
            giveUp(); // what was pressed may be gone
    });
}

void KeySheet::setFrame(qint64 frame)
{
    m_frame = frame;
    update();
}

double KeySheet::xOf(Ticks time) const
{
    return m_ruler->xOf(secondsOf(time) * m_model->timeline().framesPerSecond);
}

Ticks KeySheet::timeAt(double x) const
{
    return keys::ticksOfFrame(m_model->timeline(), m_ruler->framesAt(x));
}

void KeySheet::setCurrentRow(std::size_t row)
{
    if (m_model->rows().empty())
        return;
    m_row = std::min(row, m_model->rows().size() - 1);
    m_current = nameOf(m_model->rows()[m_row]);
    scrollTo(m_row);
    update();
}

KeySheet::RowName KeySheet::nameOf(const KeyRow& row)
{
    return {row.kind, row.node, row.channel};
}

/// Other rows came or went: the current one is where it stands now. One that is gone leaves its place to the
/// row that came there.
std::size_t KeySheet::rowOfCurrent() const
{
    const auto& rows = m_model->rows();
    const auto found = std::ranges::find(rows, m_current, &KeySheet::nameOf);
    return found != rows.end() ? std::size_t(found - rows.begin())
                               : std::min(m_row, std::max<std::size_t>(rows.size(), 1) - 1);
}

void KeySheet::fit()
{
    auto span = keys::spanOf(m_model->selection());
    if (!span && !m_model->rows().empty() && !m_model->rows().front().times.empty())
        span = {m_model->rows().front().times.front(), m_model->rows().front().times.back()};
    if (!span)
        return;
    const double rate = m_model->timeline().framesPerSecond;
    const double from = secondsOf(span->first) * rate, to = secondsOf(span->second) * rate;
    const double pad = std::max(2.0, 0.05 * (to - from));
    m_ruler->showFrames(from - pad, to + pad);
}

/// The marks of one row: of the selected keys, where they are dragged to, or of the others.
void KeySheet::collect(const KeyRow& row, bool selected)
{
    m_marks.clear();
    const auto add = [this](double x, KeyMode mode) {
        if (x < -keySide || x > width() + keySide)
            return;
        if (!m_marks.empty() && x - m_marks.back().to < leastGap)
            m_marks.back().to = x;
        else
            m_marks.push_back({x, x, mode});
    };
    const auto modeOf = [&row](std::size_t i) { return row.modes.empty() ? KeyMode::Linear : row.modes[i]; };
    const bool moves = m_preview != Retiming();
    if (selected && moves) {
        const bool backwards = m_preview.factor < 0.0;
        for (std::size_t k = 0; k < row.selected.size(); ++k) {
            const Ticks time = row.selected[backwards ? row.selected.size() - 1 - k : k];
            const auto at = std::lower_bound(row.times.begin(), row.times.end(), time) - row.times.begin();
            add(xOf(shownTime(time)), modeOf(static_cast<std::size_t>(at)));
        }
        return;
    }
    const auto first = std::lower_bound(row.times.begin(), row.times.end(), timeAt(-keySide));
    const Ticks last = timeAt(width() + keySide);
    auto mark = std::lower_bound(row.selected.begin(), row.selected.end(), timeAt(-keySide));
    for (auto time = first; time != row.times.end() && *time <= last; ++time) {
        while (mark != row.selected.end() && *mark < *time)
            ++mark;
        const bool isSelected = mark != row.selected.end() && *mark == *time;
        if (isSelected == selected || (!selected && m_copies))
            add(xOf(*time), modeOf(static_cast<std::size_t>(time - row.times.begin())));
    }
}

const QPixmap& KeySheet::glyph(KeyMode mode, bool aggregate, bool selected)
{
    const int easing = static_cast<int>(KeyMode::Sine);
    const int id = std::min(static_cast<int>(mode), easing) * 4 + (aggregate ? 2 : 0) + (selected ? 1 : 0);
    QPixmap& pixmap = m_glyphs[id];
    if (!pixmap.isNull())
        return pixmap;
    const double side = keySide + 4.0;
    pixmap = QPixmap((QSizeF(side, side) * devicePixelRatioF()).toSize());
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::WindowText);
    painter.setPen(QPen(selected ? text : blended(base, text, 0.45), selected ? 1.3 : 1.0));
    painter.setBrush(selected ? palette().color(QPalette::Highlight)
                              : blended(base, text, aggregate ? 0.45 : 0.75));
    paintKey(painter, {0.5 * side, 0.5 * side}, selected ? keySide + 1.0 : keySide - 1.0, mode);
    return pixmap;
}

void KeySheet::paintMarks(QPainter& painter, std::size_t index, bool selected)
{
    const KeyRow& row = m_model->rows()[index];
    collect(row, selected);
    const bool aggregate = row.kind != KeyRow::Kind::Channel;
    const double y = rowTop(index) + 0.5 * (rowHeight() - 1);
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::WindowText);
    const QColor bar = selected ? palette().color(QPalette::Highlight) : blended(base, text, 0.5);
    for (const Mark& mark : m_marks) {
        if (mark.to - mark.from < 0.5) {
            const QPixmap& picture = glyph(mark.mode, aggregate, selected);
            const double half = 0.5 * (keySide + 4.0);
            painter.drawPixmap(QPointF(std::round(mark.from - half), std::round(y - half)), picture);
        } else {
            painter.fillRect(QRectF(mark.from - 2.0, y - 3.0, mark.to - mark.from + 4.0, 6.0), bar);
        }
    }
}

void KeySheet::paintGrid(QPainter& painter) const
{
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::WindowText);
    const TimelineSettings& timeline = m_model->timeline();
    const double left = m_ruler->xOf(double(timeline.firstFrame)),
                 right = m_ruler->xOf(double(timeline.lastFrame));
    QColor outside = text;
    outside.setAlphaF(0.07f);
    painter.fillRect(QRectF(0.0, 0.0, std::max(0.0, left), height()), outside);
    painter.fillRect(QRectF(right, 0.0, std::max(0.0, width() - right), height()), outside);
    if (m_row < m_model->rows().size() && hasFocus()) {
        painter.setPen(QPen(blended(base, palette().color(QPalette::Highlight), 0.6), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(0.5, rowTop(m_row) + 0.5, width() - 1.0, rowHeight() - 2.0));
    }
}

/// Over the selection, with a grip at each end; only where there is something to scale.
void KeySheet::paintScaleBar(QPainter& painter) const
{
    painter.fillRect(QRect(0, 0, width(), strip), palette().base());
    const auto span = keys::spanOf(m_model->selection());
    if (!span || span->first == span->second)
        return;
    double left = xOf(shownTime(span->first)), right = xOf(shownTime(span->second));
    if (left > right)
        std::swap(left, right);
    QColor colour = palette().color(QPalette::Highlight);
    painter.setPen(Qt::NoPen);
    QColor soft = colour;
    soft.setAlphaF(0.35f);
    painter.fillRect(QRectF(left, 4.0, right - left, strip - 8.0), soft);
    painter.setBrush(colour);
    for (const double x : {left, right})
        painter.drawRoundedRect(QRectF(x - 3.0, 1.5, 6.0, strip - 3.0), 2.0, 2.0);
}

void KeySheet::paintOver(QPainter& painter) const
{
    const QColor accent = palette().color(QPalette::Highlight);
    painter.setPen(QPen(accent, 1.6));
    const double x = std::floor(m_ruler->xOf(double(m_frame))) + 0.5;
    painter.drawLine(QPointF(x, 0.0), QPointF(x, height()));
    if (m_drag == Drag::Box && m_moved) {
        QColor soft = accent;
        soft.setAlphaF(0.15f);
        painter.setPen(QPen(accent, 1.0));
        painter.setBrush(soft);
        painter.drawRect(QRectF(m_press, m_at).normalized());
    }
    if (hasFocus()) {
        painter.setPen(QPen(accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void KeySheet::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintRows(painter);
    paintGrid(painter);
    const auto [first, last] = rowsInSight();
    painter.setClipRect(QRect(0, strip, width(), height() - strip));
    for (std::size_t i = first; i < last; ++i) {
        paintMarks(painter, i, false);
        paintMarks(painter, i, true);
    }
    painter.setClipping(false);
    paintScaleBar(painter);
    paintOver(painter);
}

QString KeySheet::tipAt(const QPoint& position) const
{
    if (handleAt(position) != Drag::None)
        return tr("Drag to scale the selected keys in time; Shift: without snapping");
    const auto row = rowAt(position.y());
    const auto time = row ? keyAt(*row, position.x()) : std::nullopt;
    if (!time)
        return {};
    const double frame = secondsOf(*time) * m_model->timeline().framesPerSecond;
    QString tip = tr("Frame %1, %2 s")
                      .arg(locale().toString(frame, 'g', 10), locale().toString(secondsOf(*time), 'f', 3));
    const KeyRow& held = m_model->rows()[*row];
    if (held.kind == KeyRow::Kind::Channel) {
        const auto at = std::lower_bound(held.times.begin(), held.times.end(), *time) - held.times.begin();
        tip += QStringLiteral(" · ") + keyModeText(held.modes[static_cast<std::size_t>(at)]);
        const auto track = keys::find(m_model->document()->scene(), held.tracks.front());
        if (const auto* number = track ? std::get_if<Track>(track.get()) : nullptr)
            if (const auto index = number->find(*time))
                tip += QStringLiteral(" · ") + channelFormat(held.channel).text(number->keys()[*index].value);
    }
    return tip;
}

bool KeySheet::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::PaletteChange:
        m_glyphs.clear();
        break;
    case QEvent::ShortcutOverride: {
        // These keys mean the keys of the sheet while it has the focus, not the nodes of the scene.
        const auto* key = static_cast<QKeyEvent*>(event);
        static constexpr std::array plain{
            Qt::Key_Delete,       Qt::Key_Home,  Qt::Key_Escape,   Qt::Key_K,  Qt::Key_BracketLeft,
            Qt::Key_BracketRight, Qt::Key_Plus,  Qt::Key_Minus,    Qt::Key_Up, Qt::Key_Down,
            Qt::Key_Left,         Qt::Key_Right, Qt::Key_Backspace};
        static constexpr std::array control{Qt::Key_A, Qt::Key_C, Qt::Key_X, Qt::Key_V, Qt::Key_D, Qt::Key_M};
        const auto held = key->modifiers() & ~Qt::KeypadModifier;
        const bool isPlain =
            std::count(plain.begin(), plain.end(), key->key()) > 0 && !(held & Qt::ControlModifier);
        const bool isControl =
            std::count(control.begin(), control.end(), key->key()) > 0 && (held & Qt::ControlModifier);
        if (isPlain || isControl) {
            event->accept();
            return true;
        }
        break;
    }
    case QEvent::ToolTip: {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    default:
        break;
    }
    return KeyRowsView::event(event);
}

} // namespace ramure
