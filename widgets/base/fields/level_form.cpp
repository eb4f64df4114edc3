#include "widgets/base/fields/level_form.h"

#include "widgets/base/named.h"
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <utility>

namespace ramure {

static QString budgetsText(const LevelOptions& options)
{
    QStringList budgets;
    for (const std::int64_t budget : options.budgets)
        budgets += QString::number(budget);
    return budgets.join(QStringLiteral(", "));
}

LevelForm::LevelForm(QWidget* parent)
    : QWidget(parent)
    , m_count(named(new QSpinBox(this), "exportLevels"))
    , m_label(new QLabel(tr("Triangles"), this))
    , m_fromLabel(new QLabel(tr("From"), this))
    , m_budgets(named(new QLineEdit(this), "exportBudgets"))
    , m_from(named(new QLineEdit(this), "exportSwitches"))
    , m_cards(named(new QCheckBox(tr("Twigs as pictures on cards"), this), "exportCards"))
    , m_billboard(named(new QCheckBox(tr("A billboard as the last level"), this), "exportBillboard"))
{
    m_count->setRange(1, static_cast<int>(mostLevels));
    m_label->setBuddy(m_budgets);
    m_fromLabel->setBuddy(m_from);
    auto* rows = layoutOf<QGridLayout>(this, 6);
    rows->setColumnStretch(2, 1);
    rows->addWidget(m_count, 0, 0);
    rows->addWidget(m_label, 0, 1);
    rows->addWidget(m_budgets, 0, 2);
    rows->addWidget(m_fromLabel, 1, 1);
    rows->addWidget(m_from, 1, 2);
    rows->addWidget(m_cards, 2, 1, 1, 2);
    rows->addWidget(m_billboard, 3, 1, 1, 2);
    connect(m_count, &QSpinBox::valueChanged, this, &LevelForm::takeCount);
    connect(m_budgets, &QLineEdit::textChanged, this, &LevelForm::changed);
    connect(m_from, &QLineEdit::textChanged, this, &LevelForm::changed);
    connect(m_cards, &QCheckBox::toggled, this, &LevelForm::changed);
    connect(m_billboard, &QCheckBox::toggled, this, &LevelForm::takeCount);
    setFocusProxy(m_count);
    m_count->setToolTip(
        tr("Meshes of each tree, 1 to 8, for less and less triangles. A GLB holds them all; of other "
           "formats each is a file."));
    m_count->setAccessibleName(tr("Number of levels"));
    m_budgets->setPlaceholderText(tr("the tree as it is, then a quarter or less each"));
    m_budgets->setToolTip(tr(
        "Triangles of each level, with commas between them, such as 10000, 2500: bark, leaves and "
        "fruit together, kept within 2 %. Nothing here: the first level is the tree as it is, each "
        "further one has a quarter of the one before; less, often an eighth, where its bark would keep more "
        "than half of its triangles, as in a tree full of leaves."));
    m_budgets->setAccessibleName(tr("Triangles of each level"));
    m_from->setPlaceholderText(tr("60 % of the picture's height, then half of it each"));
    m_from->setToolTip(
        tr("When each level but the first takes the place of the one before. Metres from the eye, rising, "
           "such as 20; 60, for a vertical angle of view of 40°. Or shares of the picture's height that the "
           "tree has, falling, such as 60 %; 30 %, as engines have them: they suit a tree of any size. "
           "Nothing here: 60 %, then half of it each."));
    m_from->setAccessibleName(tr("When each level is shown"));
    m_cards->setToolTip(
        tr("Where not all leaves are there, crossed cards show pictures of this tree's own twigs in the "
           "place of "
           "fewer and larger leaves: outlines stay, and the picture needs its opacity. For GLB and OBJ with "
           "pictures, and leaves without pictures of their own."));
    m_billboard->setToolTip(tr(
        "One level more, for trees that are far away: three crossed cards with pictures of the whole tree, "
        "six triangles, in the place of bark, leaves and fruit. For GLB and OBJ with pictures."));
}

LevelOptions LevelForm::options() const
{
    LevelOptions options;
    // Digits may be grouped, by a space for example: commas and semicolons alone part numbers.
    const QString text = m_budgets->text();
    for (QString budget : text.split(QRegularExpression(QStringLiteral("[,;]")), Qt::SkipEmptyParts))
        if (budget.remove(QRegularExpression(QStringLiteral("\\s"))); !budget.isEmpty())
            options.budgets.push_back(budget.toLongLong());
    options.billboard = m_billboard->isChecked();
    if (m_count->value() > 1 || !options.budgets.empty() || options.billboard)
        options.count = m_count->value();
    options.cards = m_cards->isChecked();
    (void)readSwitches(m_from->text().toStdString(), options); // check() tells
    return options;
}

/// A level more has a quarter of the triangles of the one before it and is seen from twice as far; of levels
/// that are gone, so are both.
void LevelForm::takeCount()
{
    LevelOptions now = options();
    const auto meshes = static_cast<std::size_t>(m_count->value());
    const std::size_t wanted = meshes - (now.billboard ? 0 : 1);
    bool isOther = false;
    while (!now.budgets.empty() && now.budgets.size() != meshes) {
        isOther = true;
        if (now.budgets.size() > meshes)
            now.budgets.pop_back();
        else
            now.budgets.push_back(std::max(now.budgets.back() / 4, leastBudget));
    }
    for (auto [numbers, step] : {std::pair(&now.distances, 2.0), std::pair(&now.shares, usualShareStep)})
        while (!numbers->empty() && numbers->size() != wanted) {
            isOther = true;
            if (numbers->size() > wanted)
                numbers->pop_back();
            else
                numbers->push_back(step * numbers->back());
        }
    if (isOther) {
        const QSignalBlocker once(m_from), too(m_budgets);
        m_from->setText(QString::fromStdString(switchesText(now)));
        m_budgets->setText(budgetsText(now));
    }
    emit changed();
}

void LevelForm::setOptions(const LevelOptions& options)
{
    const bool isOther = m_billboard->isChecked() != options.billboard;
    {
        const QSignalBlocker once(m_billboard); // the switches that it counts are set below
        m_billboard->setChecked(options.billboard);
    }
    m_count->setValue(std::max(1, static_cast<int>(options.count)));
    m_budgets->setText(budgetsText(options));
    m_from->setText(QString::fromStdString(switchesText(options)));
    m_cards->setChecked(options.cards);
    if (isOther)
        emit changed();
}

QVariantMap LevelForm::settingsOf(const LevelOptions& options)
{
    QVariantList budgets;
    for (const std::int64_t budget : options.budgets)
        budgets += qlonglong(budget);
    return {{"levels", qlonglong(options.count)},
            {"budgets", budgets},
            {"switches", QString::fromStdString(switchesText(options))},
            {"cards", options.cards},
            {"billboard", options.billboard}};
}

LevelOptions LevelForm::optionsIn(const QVariantMap& settings)
{
    LevelOptions options;
    options.count = settings.value(QStringLiteral("levels")).toLongLong();
    for (const QVariant& budget : settings.value(QStringLiteral("budgets")).toList())
        options.budgets.push_back(budget.toLongLong());
    options.cards = settings.value(QStringLiteral("cards")).toBool();
    options.billboard = settings.value(QStringLiteral("billboard")).toBool();
    (void)readSwitches(settings.value(QStringLiteral("switches")).toString().toStdString(), options);
    return options;
}

void LevelForm::setNarrow()
{
    m_budgets->setPlaceholderText(tr("as it is, then a quarter or less", "the tree"));
    m_from->setPlaceholderText(tr("60 %, then half of it each"));
}

Expected<void> LevelForm::check() const
{
    static const QRegularExpression numbers(QStringLiteral("^[\\d\\s,;]*$"));
    if (!numbers.match(m_budgets->text()).hasMatch())
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("budgets are numbers of triangles, with commas between them"));
    LevelOptions wanted;
    RAMURE_TRY(readSwitches(m_from->text().toStdString(), wanted));
    wanted = options();
    return wanted.isWanted() ? checkLevels(wanted) : Expected<void>();
}

} // namespace ramure
