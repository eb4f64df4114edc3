#include "widgets/panels/properties/param_row.h"

#include "core/presets/presets.h"
#include "widgets/base/fields/key_button.h"
#include "widgets/base/named.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/properties/param_editor_factory.h"
#include "widgets/panels/properties/param_facts.h"
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>

namespace ramure {

QString paramToolTip(const ParamDef& def, AngleUnit unit, const std::string& preset)
{
    QString text = QStringLiteral("<p><b>%1</b><br>%2</p>")
                       .arg(coreText(def.label).toHtmlEscaped(), coreText(def.tooltip).toHtmlEscaped());
    QStringList facts;
    const auto add = [&](const QString& name, const QString& value) {
        facts +=
            QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>").arg(name, value.toHtmlEscaped());
    };
    for (const auto& [name, value] : paramFacts(def, unit, preset))
        add(name, value);
    add(ParamRow::tr("Key"), QString::fromLatin1(def.key));
    return text + QStringLiteral("<table>%1</table>").arg(facts.join(QString()));
}

ParamRow::ParamRow(const ParamDef& def, QWidget* parent)
    : QWidget(parent)
    , m_label(new QLabel(coreText(def.label), this))
    , m_editor(makeParamEditor(def, this))
    , m_reset(new QToolButton(this))
    , m_message(named(new QLabel(this), "problem"))
{
    auto* grid = layoutOf<QGridLayout>(this);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    auto* name = new QHBoxLayout;
    name->setSpacing(2);
    if (isKeyable(def)) {
        m_key = newKeyButton(this);
        name->addWidget(m_key);
        connect(m_key, &QToolButton::clicked, this, &ParamRow::keyToggled);
    }
    name->addWidget(m_label, 1);
    if (m_editor->isWide()) {
        grid->addLayout(name, 0, 0, 1, 2);
        grid->addWidget(m_reset, 0, 2);
        grid->addWidget(m_editor, 1, 0, 1, 3);
        grid->addWidget(m_message, 2, 0, 1, 3);
    } else {
        grid->addLayout(name, 0, 0);
        grid->addWidget(m_editor, 0, 1);
        grid->addWidget(m_reset, 0, 2);
        grid->addWidget(m_message, 1, 0, 1, 3);
    }
    if (!paramMeaning(def, defaultValue(def)).isEmpty()) {
        m_meaning = named(new QLabel(this), "dim");
        grid->addWidget(m_meaning, grid->rowCount(), 1);
    }
    grid->setColumnStretch(1, 1);
    m_label->setBuddy(m_editor);
    m_editor->addHandle(m_label);
    m_label->setWordWrap(!m_editor->isWide()); // long names in a narrow panel
    m_reset->setAutoRaise(true);
    m_reset->setIcon(icon("reset"));
    m_reset->setIconSize({14, 14});
    m_reset->setFocusPolicy(Qt::TabFocus);
    QSizePolicy keepsPlace = m_reset->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(keepsPlace);
    m_reset->hide();
    m_message->setWordWrap(true);
    m_message->hide();
    connect(m_reset, &QToolButton::clicked, this, &ParamRow::resetRequested);
    connect(m_editor, &ParamEditor::refused, this, &ParamRow::showRefusal);
    connect(m_editor, &ParamEditor::held, this, &ParamRow::showRefusal);
    showToolTips();
}

QString ParamRow::message() const
{
    return m_message->text();
}

void ParamRow::showValues(std::span<const ParamValue> values, std::span<const std::string> presets)
{
    std::vector<ParamValue> standards;
    for (const std::string& preset : presets)
        standards.push_back(presetValue(preset, def()));
    const bool onePreset =
        !presets.empty() && std::ranges::count(presets, presets.front()) == std::ssize(presets);
    m_preset = onePreset ? presets.front() : std::string();
    m_editor->setStandard(commonValue(standards));
    m_editor->showValues(values);
    if (m_meaning) {
        const auto common = commonValue(values);
        m_meaning->setText(common ? paramMeaning(def(), *common) : QStringLiteral("–"));
    }
    showToolTips();
    m_changed = !std::ranges::equal(values, standards);
    m_reset->setVisible(m_changed);
    QFont font = m_label->font();
    font.setBold(m_changed);
    m_label->setFont(font);
    showRefusal({});
}

void ParamRow::showProblem(const std::optional<Error>& error)
{
    m_problem = error;
    m_editor->showProblem(error);
    showMessage();
}

void ParamRow::showRefusal(const QString& reason)
{
    m_refusal = reason;
    showMessage();
}

void ParamRow::showMessage()
{
    QString text = m_refusal;
    if (text.isEmpty() && m_problem) {
        Error error = *m_problem;
        error.path.clear(); // the row itself is the place
        text = errorTextWithPlace(error);
    }
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    m_message->setText(text);
    m_message->setVisible(!m_editor->showMessage(text) && !text.isEmpty());
}

void ParamRow::showKeyState(KeyState state)
{
    if (!m_key)
        return;
    m_key->show();
    ramure::showKeyState(m_key, coreText(def().label), state);
}

void ParamRow::setActs(bool acts)
{
    if (m_acts == acts)
        return;
    m_acts = acts;
    for (QWidget* part :
         {static_cast<QWidget*>(m_label), static_cast<QWidget*>(m_editor), static_cast<QWidget*>(m_reset),
          static_cast<QWidget*>(m_key), static_cast<QWidget*>(m_meaning)})
        if (part)
            part->setEnabled(acts);
    showToolTips();
}

void ParamRow::setAngleUnit(AngleUnit unit)
{
    m_angleUnit = unit;
    m_editor->setAngleUnit(unit);
    showToolTips();
}

int ParamRow::labelWidth() const
{
    if (m_editor->isWide())
        return 0;
    QFont bold = m_label->font();
    bold.setBold(true); // a changed value must not move its neighbours
    const int key = m_key && !m_key->isHidden() ? keyButtonSide + 2 : 0;
    return QFontMetrics(bold).horizontalAdvance(coreText(def().label)) + 2 + key;
}

void ParamRow::addBelow(QWidget* widget)
{
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->addWidget(widget, grid->rowCount(), 0, 1, 3);
}

void ParamRow::setLabelWidth(int width)
{
    if (!m_editor->isWide())
        m_label->setFixedWidth(width - (m_key && !m_key->isHidden() ? keyButtonSide + 2 : 0));
}

bool ParamRow::matches(const QStringList& words) const
{
    const QString text = (coreText(def().label) + u' ' + coreText(def().group) + u' ' +
                          coreText(def().tooltip) + u' ' + QString::fromLatin1(def().key))
                             .toLower();
    return std::ranges::all_of(words, [&](const QString& word) { return text.contains(word); });
}

bool ParamRow::isCalled(const QStringList& words) const
{
    const QString name = coreText(def().label).toLower();
    return std::ranges::all_of(words, [&](const QString& word) { return name.contains(word); });
}

void ParamRow::contextMenuEvent(QContextMenuEvent* event)
{
    emit menuRequested(event->globalPos());
}

void ParamRow::showToolTips()
{
    QString tip = paramToolTip(def(), m_angleUnit, m_preset);
    if (!m_acts) {
        const ParamDef* off = switchOf(def());
        tip +=
            QStringLiteral("<p>%1</p>")
                .arg(off ? tr("It has no effect while “%1” is off.").arg(coreText(off->label).toHtmlEscaped())
                         : tr("It has no effect now: another value turns it off."));
    }
    m_label->setToolTip(tip);
    m_editor->setToolTip(tip);
    const bool isPresets = presetValue(m_preset, def()) != defaultValue(def());
    const bool isPicture = (def().flags & paramPicture) != 0;
    m_reset->setToolTip(isPicture   ? tr("Take the picture away")
                        : isPresets ? tr("Back to the value of %1").arg(QString::fromStdString(m_preset))
                                    : tr("Back to the default"));
    m_reset->setAccessibleName(QStringLiteral("%1: %2").arg(coreText(def().label), m_reset->toolTip()));
}

} // namespace ramure
