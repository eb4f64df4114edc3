#include "widgets/dialogs/preferences_dialog.h"

#include "widgets/base/named.h"
#include "widgets/base/theme/language.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int hintWidth = 320;

QLabel* hint(const QString& text, QWidget* parent)
{
    auto* label = named(new QLabel(text, parent), "hint");
    label->setWordWrap(true);
    label->setMinimumWidth(hintWidth);
    return label;
}

QComboBox* choice(const char* name, const QStringList& texts, QWidget* parent)
{
    auto* box = new QComboBox(parent);
    box->setObjectName(QLatin1String(name));
    box->addItems(texts);
    return box;
}

} // namespace

PreferencesDialog::PreferencesDialog(Preferences* preferences, QWidget* parent)
    : QDialog(parent)
    , m_preferences(preferences)
    , m_theme(choice("theme", {tr("As the system"), tr("Light"), tr("Dark")}, this))
    , m_language(choice("language", {tr("As the system")}, this))
    , m_units(choice("units", {tr("Degrees"), tr("Radians")}, this))
    , m_times(choice("times", {tr("Frames"), tr("Seconds"), tr("Timecode")}, this))
    , m_navigation(choice("navigation", {tr("Like Blender"), tr("Like Maya")}, this))
    , m_navigationHint(hint({}, this))
    , m_autosave(named(new QSpinBox(this), "autosave"))
    , m_memory(named(new QSpinBox(this), "motionMemory"))
    , m_welcome(named(new QCheckBox(tr("Show the &welcome page at the start"), this), "welcome"))
{
    setWindowTitle(tr("Preferences"));
    m_language->setItemData(0, QString());
    // Languages are called by their own names in every language.
    for (const auto& [code, name] : Language::available())
        m_language->addItem(name, code);
    m_autosave->setRange(0, Preferences::maxAutosaveMinutes);
    m_autosave->setSuffix(tr(" min"));
    m_autosave->setSpecialValueText(tr("Off"));
    m_memory->setRange(Preferences::leastMotionMb, Preferences::mostMotionMb);
    m_memory->setSingleStep(256);
    m_memory->setGroupSeparatorShown(true);
    m_memory->setKeyboardTracking(false); // half a number must not throw motion away
    m_memory->setSuffix(tr(" MB"));
    m_memory->setToolTip(tr("Megabytes for computed frames, of all trees together: %L1 to %L2")
                             .arg(Preferences::leastMotionMb)
                             .arg(Preferences::mostMotionMb));
    build();
    connectFields();
}

void PreferencesDialog::build()
{
    auto* layout = layoutOf<QVBoxLayout>(this, 16, {24, 20, 24, 16});
    layout->setSizeConstraint(QLayout::SetFixedSize);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    const auto add = [this, form](const QString& text, QWidget* field, QLabel* below) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        auto* column = new QVBoxLayout;
        column->setSpacing(4);
        column->addWidget(field);
        column->addWidget(below);
        form->addRow(label, column);
    };
    form->addRow(tr("&Theme:"), m_theme);
    add(tr("&Language:"), m_language, hint(tr("The language changes when Ramure is started again."), this));
    form->addRow(tr("&Angles in:"), m_units);
    form->addRow(tr("T&imes in:"), m_times);
    add(tr("&Navigation:"), m_navigation, m_navigationHint);
    add(tr("A&utosave every:"), m_autosave,
        hint(tr("Unsaved changes are kept aside, so that a crash costs no more than that. Your own file is "
                "written only when you save it."),
             this));
    add(tr("&Memory for motion:"), m_memory,
        hint(tr("With less memory, fewer moments of a long run are kept, and a jump within it computes a few "
                "more steps."),
             this));
    form->addRow(QString(), m_welcome);
    layout->addLayout(form);
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* defaults = buttons->addButton(tr("Restore defaults"), QDialogButtonBox::ResetRole);
    defaults->setObjectName(QStringLiteral("defaults"));
    defaults->setAutoDefault(false);
    buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole)->setDefault(true);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(defaults, &QPushButton::clicked, m_preferences, &Preferences::restoreDefaults);
}

/// The field shows the preference, whoever changes it, and changes it.
void PreferencesDialog::follow(QWidget* field, const std::function<void()>& show)
{
    const auto quietly = [field, show] {
        const QSignalBlocker quiet(field);
        show();
    };
    connect(m_preferences, &Preferences::changed, field, quietly);
    quietly();
}

template <class Enum> void PreferencesDialog::connectField(QComboBox* box, Preferences::Choice<Enum>& choice)
{
    follow(box, [box, &choice] { box->setCurrentIndex(static_cast<int>(choice())); });
    connect(box, &QComboBox::currentIndexChanged, this,
            [&choice](int index) { choice.set(static_cast<Enum>(index)); });
}

void PreferencesDialog::connectFields()
{
    Preferences* p = m_preferences;
    connectField(m_theme, p->theme);
    connectField(m_units, p->angleUnit);
    connectField(m_times, p->timeDisplay);
    connectField(m_navigation, p->navigationStyle);
    follow(m_language,
           [this, p] { m_language->setCurrentIndex(std::max(0, m_language->findData(p->language()))); });
    connect(m_language, &QComboBox::currentIndexChanged, this,
            [this, p](int index) { p->language.set(m_language->itemData(index).toString()); });
    follow(m_autosave, [this, p] { m_autosave->setValue(p->autosaveMinutes()); });
    connect(m_autosave, &QSpinBox::valueChanged, p, &Preferences::setAutosaveMinutes);
    follow(m_memory, [this, p] { m_memory->setValue(p->motionMemoryMb()); });
    connect(m_memory, &QSpinBox::valueChanged, p, &Preferences::setMotionMemoryMb);
    follow(m_welcome, [this, p] { m_welcome->setChecked(p->welcomeAtStart()); });
    connect(m_welcome, &QCheckBox::toggled, this, [p](bool shown) { p->welcomeAtStart.set(shown); });
    follow(m_navigationHint, [this, p] {
        m_navigationHint->setText(
            p->navigationStyle() == NavigationStyle::Maya
                ? tr("Alt with the left button orbits, with the middle one pans, with the right one zooms.")
                : tr("The middle button orbits, with Shift it pans, with Ctrl it zooms."));
    });
}

} // namespace ramure
