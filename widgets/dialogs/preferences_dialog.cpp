#include "widgets/dialogs/preferences_dialog.h"

#include "widgets/base/theme/language.h"
#include "widgets/base/theme/preferences.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr int hintWidth = 320;

QLabel* hint(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QStringLiteral("hint"));
    label->setWordWrap(true);
    label->setMinimumWidth(hintWidth);
    return label;
}

/// Replaces the texts of \p box and keeps what is chosen.
void setTexts(QComboBox* box, const QStringList& texts)
{
    if (box->count() == 0) {
        box->addItems(texts);
        return;
    }
    for (int i = 0; i < texts.size(); ++i)
        box->setItemText(i, texts[i]);
}

} // namespace

PreferencesDialog::PreferencesDialog(Preferences* preferences, QWidget* parent)
    : QDialog(parent)
    , m_preferences(preferences)
    , m_themeLabel(new QLabel(this))
    , m_theme(new QComboBox(this))
    , m_languageLabel(new QLabel(this))
    , m_language(new QComboBox(this))
    , m_unitsLabel(new QLabel(this))
    , m_units(new QComboBox(this))
    , m_timesLabel(new QLabel(this))
    , m_times(new QComboBox(this))
    , m_navigationLabel(new QLabel(this))
    , m_navigation(new QComboBox(this))
    , m_navigationHint(hint(this))
    , m_autosaveLabel(new QLabel(this))
    , m_autosave(new QSpinBox(this))
    , m_autosaveHint(hint(this))
    , m_memoryLabel(new QLabel(this))
    , m_memory(new QSpinBox(this))
    , m_memoryHint(hint(this))
    , m_welcome(new QCheckBox(this))
{
    m_navigation->setObjectName(QStringLiteral("navigation"));
    m_units->setObjectName(QStringLiteral("units"));
    m_autosave->setObjectName(QStringLiteral("autosave"));
    m_theme->setObjectName(QStringLiteral("theme"));
    m_language->setObjectName(QStringLiteral("language"));
    m_welcome->setObjectName(QStringLiteral("welcome"));
    m_times->setObjectName(QStringLiteral("times"));
    m_memory->setObjectName(QStringLiteral("motionMemory"));
    m_memory->setRange(Preferences::leastMotionMb, Preferences::mostMotionMb);
    m_memory->setSingleStep(256);
    m_memory->setGroupSeparatorShown(true);
    m_memory->setKeyboardTracking(false); // half a number must not throw motion away
    m_autosave->setRange(0, Preferences::maxAutosaveMinutes);
    build();
    retranslate();
    take();
    connectFields();
}

void PreferencesDialog::build()
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 16);
    layout->setSpacing(16);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(10);
    const auto add = [form](QLabel* label, QWidget* field, QLabel* below = nullptr) {
        label->setBuddy(field);
        if (!below) {
            form->addRow(label, field);
            return;
        }
        auto* column = new QVBoxLayout;
        column->setSpacing(4);
        column->addWidget(field);
        column->addWidget(below);
        form->addRow(label, column);
    };
    add(m_themeLabel, m_theme);
    add(m_languageLabel, m_language);
    add(m_unitsLabel, m_units);
    add(m_timesLabel, m_times);
    add(m_navigationLabel, m_navigation, m_navigationHint);
    add(m_autosaveLabel, m_autosave, m_autosaveHint);
    add(m_memoryLabel, m_memory, m_memoryHint);
    form->addRow(QString(), m_welcome);
    layout->addLayout(form);
    auto* buttons = new QDialogButtonBox(this);
    m_defaults = buttons->addButton(QString(), QDialogButtonBox::ResetRole);
    m_defaults->setObjectName(QStringLiteral("defaults"));
    m_defaults->setAutoDefault(false);
    m_close = buttons->addButton(QString(), QDialogButtonBox::RejectRole);
    m_close->setDefault(true);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_defaults, &QPushButton::clicked, m_preferences, &Preferences::restoreDefaults);
}

void PreferencesDialog::connectFields()
{
    const auto on = [this](QComboBox* box, auto apply) {
        connect(box, &QComboBox::currentIndexChanged, this, [this, apply](int index) {
            if (!m_taking && index >= 0)
                apply(index);
        });
    };
    on(m_navigation,
       [this](int index) { m_preferences->setNavigationStyle(static_cast<NavigationStyle>(index)); });
    on(m_units, [this](int index) { m_preferences->setAngleUnit(static_cast<AngleUnit>(index)); });
    on(m_times, [this](int index) { m_preferences->setTimeDisplay(static_cast<TimeDisplay>(index)); });
    on(m_theme, [this](int index) { m_preferences->setTheme(static_cast<ThemeChoice>(index)); });
    on(m_language, [this](int index) { m_preferences->setLanguage(m_language->itemData(index).toString()); });
    connect(m_autosave, &QSpinBox::valueChanged, this, [this](int minutes) {
        if (!m_taking)
            m_preferences->setAutosaveMinutes(minutes);
    });
    connect(m_memory, &QSpinBox::valueChanged, this, [this](int megabytes) {
        if (!m_taking)
            m_preferences->setMotionMemoryMb(megabytes);
    });
    connect(m_welcome, &QCheckBox::toggled, this, [this](bool shown) {
        if (!m_taking)
            m_preferences->setWelcomeAtStart(shown);
    });
    connect(m_preferences, &Preferences::changed, this, &PreferencesDialog::take);
}

void PreferencesDialog::take()
{
    m_taking = true;
    m_navigation->setCurrentIndex(static_cast<int>(m_preferences->navigationStyle()));
    m_units->setCurrentIndex(static_cast<int>(m_preferences->angleUnit()));
    m_times->setCurrentIndex(static_cast<int>(m_preferences->timeDisplay()));
    m_memory->setValue(m_preferences->motionMemoryMb());
    m_theme->setCurrentIndex(static_cast<int>(m_preferences->theme()));
    m_language->setCurrentIndex(std::max(0, m_language->findData(m_preferences->language())));
    m_autosave->setValue(m_preferences->autosaveMinutes());
    m_welcome->setChecked(m_preferences->welcomeAtStart());
    m_taking = false;
    m_navigationHint->setText(
        m_preferences->navigationStyle() == NavigationStyle::Maya
            ? tr("Alt with the left button orbits, with the middle one pans, with the right one zooms.")
            : tr("The middle button orbits, with Shift it pans, with Ctrl it zooms."));
}

void PreferencesDialog::retranslate()
{
    setWindowTitle(tr("Preferences"));
    m_themeLabel->setText(tr("&Theme:"));
    setTexts(m_theme, {tr("As the system"), tr("Light"), tr("Dark")});
    m_languageLabel->setText(tr("&Language:"));
    if (m_language->count() == 0) {
        m_language->addItem(QString(), QString());
        // Languages are called by their own names in every language.
        for (const auto& [code, name] : Language::available())
            m_language->addItem(name, code);
    }
    m_language->setItemText(0, tr("As the system"));
    m_unitsLabel->setText(tr("&Angles in:"));
    setTexts(m_units, {tr("Degrees"), tr("Radians")});
    m_timesLabel->setText(tr("T&imes in:"));
    setTexts(m_times, {tr("Frames"), tr("Seconds"), tr("Timecode")});
    m_navigationLabel->setText(tr("&Navigation:"));
    setTexts(m_navigation, {tr("Like Blender"), tr("Like Maya")});
    m_autosaveLabel->setText(tr("A&utosave every:"));
    m_autosave->setSuffix(tr(" min"));
    m_autosave->setSpecialValueText(tr("Off"));
    m_autosaveHint->setText(
        tr("Unsaved changes are kept aside, so that a crash costs no more than that. Your own file is "
           "written only when you save it."));
    m_memoryLabel->setText(tr("&Memory for motion:"));
    m_memory->setLocale(QLocale()); // its own is of the language it was made in
    m_memory->setSuffix(tr(" MB"));
    m_memory->setToolTip(tr("Megabytes for computed frames, of all trees together: %L1 to %L2")
                             .arg(Preferences::leastMotionMb)
                             .arg(Preferences::mostMotionMb));
    m_memoryHint->setText(tr("With less, fewer moments of a long run are kept: a jump within it computes "
                             "a few steps more."));
    m_welcome->setText(tr("Show the &welcome page at the start"));
    m_defaults->setText(tr("Restore defaults"));
    m_close->setText(tr("Close"));
    take();
}

void PreferencesDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

} // namespace ramure
