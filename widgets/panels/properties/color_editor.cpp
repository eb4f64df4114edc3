#include "widgets/panels/properties/color_editor.h"

#include "widgets/base/named.h"
#include <QAbstractButton>
#include <QColorDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <algorithm>

namespace ramure {
namespace {

constexpr QSize swatchSize(40, 24);

/// A rounded rectangle of the colour; two halves of grey where the nodes differ.
class Swatch : public QAbstractButton
{
public:
    explicit Swatch(QWidget* parent)
        : QAbstractButton(parent)
    {
        setFixedSize(swatchSize);
        setFocusPolicy(Qt::StrongFocus);
        setCursor(Qt::PointingHandCursor);
        setObjectName(QStringLiteral("colorSwatch"));
    }
    void setColor(const std::optional<QColor>& color)
    {
        m_color = color;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QPainterPath outline;
        outline.addRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
        painter.save();
        painter.setClipPath(outline);
        QColor shown = m_color.value_or(palette().color(QPalette::Mid));
        if (!isEnabled())
            shown.setAlphaF(0.4F);
        painter.fillRect(rect(), shown);
        if (!m_color)
            painter.fillRect(rect().adjusted(width() / 2, 0, 0, 0), palette().color(QPalette::Midlight));
        painter.restore();
        const bool isMarked = hasFocus() || underMouse();
        painter.setPen(
            QPen(palette().color(isMarked ? QPalette::Highlight : QPalette::Mid), hasFocus() ? 2.0 : 1.0));
        painter.drawPath(outline);
    }
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }

private:
    std::optional<QColor> m_color;
};

} // namespace

QColor screenColor(const glm::dvec3& value)
{
    const auto part = [](double x) { return static_cast<float>(std::clamp(x, 0.0, 1.0)); };
    return QColor::fromRgbF(part(value.x), part(value.y), part(value.z));
}

glm::dvec3 colorValue(const QColor& color)
{
    return {color.red() / 255.0, color.green() / 255.0, color.blue() / 255.0};
}

ColorEditor::ColorEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
    , m_swatch(new Swatch(this))
    , m_text(new QLineEdit(this))
{
    auto* layout = layoutOf<QHBoxLayout>(this, 6);
    layout->addWidget(m_swatch);
    layout->addWidget(m_text, 1);
    m_text->setMaxLength(32);
    m_swatch->setAccessibleName(tr("%1: choose").arg(name()));
    m_swatch->setToolTip(tr("Choose a colour"));
    m_text->setAccessibleName(name());
    setFocusProxy(m_text);
    connect(m_swatch, &QAbstractButton::clicked, this, &ColorEditor::openDialog);
    connect(m_text, &QLineEdit::editingFinished, this, &ColorEditor::takeText);
}

void ColorEditor::showValues(std::span<const ParamValue> values)
{
    m_value = commonValue(values);
    std::optional<QColor> color;
    if (m_value)
        color = screenColor(std::get<glm::dvec3>(*m_value));
    static_cast<Swatch*>(m_swatch)->setColor(color);
    if (m_text->isModified() && m_text->hasFocus())
        return; // what is being typed stays
    m_text->setText(color ? color->name() : QString());
    m_text->setPlaceholderText(color ? QString() : QStringLiteral("—"));
}

void ColorEditor::takeText()
{
    if (!m_text->isModified())
        return;
    m_text->setModified(false);
    static const QRegularExpression shape(QStringLiteral("^#?([0-9a-fA-F]{6}|[0-9a-fA-F]{3})$"));
    const auto match = shape.match(m_text->text().trimmed());
    if (!match.hasMatch()) {
        const QString typed = m_text->text();
        if (m_value)
            m_text->setText(screenColor(std::get<glm::dvec3>(*m_value)).name());
        emit refused(tr("“%1” is no colour: write six digits like #8b5a2b").arg(typed));
        return;
    }
    emit refused(QString());
    emitSingleEdit(colorValue(QColor(u'#' + match.captured(1))));
}

void ColorEditor::openDialog()
{
    if (m_dialog) {
        m_dialog->raise();
        m_dialog->activateWindow();
        return;
    }
    const std::optional<ParamValue> before = m_value;
    nextGesture(); // all that is tried in the dialog is one undo step
    m_dialog = new QColorDialog(before ? screenColor(std::get<glm::dvec3>(*before)) : QColor(Qt::lightGray),
                                window());
    m_dialog->setOption(QColorDialog::DontUseNativeDialog);
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_dialog->setWindowTitle(name());
    connect(m_dialog, &QColorDialog::currentColorChanged, this, [this, before](const QColor& color) {
        if (before) // nodes of several colours change only when the choice is made: no way back else
            emitEdit(colorValue(color));
    });
    connect(m_dialog, &QDialog::accepted, this, [this] { emitEdit(colorValue(m_dialog->currentColor())); });
    connect(m_dialog, &QDialog::rejected, this, [this, before] {
        if (before)
            emitEdit(*before);
    });
    connect(m_dialog, &QObject::destroyed, this, [this] { m_dialog = nullptr; });
    m_dialog->open();
}

} // namespace ramure
