#include "widgets/dialogs/variations/seeds_dialog.h"

#include "core/generators/variety.h"
#include "core/presets/named_seeds.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/planting.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/presets/preset_gallery.h"
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int columns = 3;

/// Years: young, mature and old, of a species as it ships.
std::array<double, 3> agesOf(const Node& tree)
{
    const auto preset = std::ranges::find(presets(), std::string_view(tree.preset), &Preset::name);
    if (preset != presets().end() && preset->ages[0] > 0)
        return {double(preset->ages[0]), double(preset->ages[1]), double(preset->ages[2])};
    const double mature = std::max(std::round(tree.params.growth.maturity), 2.0);
    return {std::ceil(0.3 * mature), mature, 2.0 * mature};
}

} // namespace

SeedsDialog::SeedsDialog(Document* document, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_hint(new QLabel(this))
    , m_agesBox(new QCheckBox(tr("At three &ages"), this))
{
    setObjectName(QStringLiteral("seeds"));
    m_hint->setWordWrap(true);
    auto* grid = new QGridLayout;
    grid->setSpacing(12);
    for (int i = 0; i < count; ++i) {
        m_choices[std::size_t(i)] = new PictureButton(QString(), PictureButton::usualWidth, this);
        grid->addWidget(m_choices[std::size_t(i)], i / columns, i % columns);
        connect(m_choices[std::size_t(i)], &QAbstractButton::clicked, this, [this, i] { choose(i); });
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_other = buttons->addButton(tr("Nine &others"), QDialogButtonBox::ActionRole);
    m_other->setAutoDefault(false);
    m_agesBox->setToolTip(tr("Three seeds, each young, mature and old"));
    connect(m_agesBox, &QCheckBox::toggled, this,
            [this] { begin(m_like.params.grammar.seed + 1, m_hasNames); });
    connect(m_other, &QPushButton::clicked, this, [this] { begin(seedOf(count - 1) + 1, false); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_hint);
    layout->addWidget(m_agesBox);
    layout->addLayout(grid);
    layout->addWidget(buttons);
    layout->setSizeConstraint(QLayout::SetFixedSize);
}

void SeedsDialog::offerNew(const Node& like)
{
    m_tree = noNode;
    offer(like);
}

void SeedsDialog::offerFor(NodeId tree)
{
    const Node* like = m_document->scene().find(tree);
    if (!like)
        return;
    m_tree = tree;
    offer(*like);
}

void SeedsDialog::offer(const Node& like)
{
    m_like = like;
    const auto preset = presetParams(like.preset);
    NodeParams asItShips = preset.value_or(NodeParams());
    asItShips.growth.age = like.params.growth.age;
    m_hasNames = preset && asItShips.weberPenn == like.params.weberPenn &&
                 asItShips.colonisation == like.params.colonisation &&
                 asItShips.growth == like.params.growth && namedSeeds(like.preset);
    m_ages = agesOf(like);
    m_agesBox->setVisible(like.params.generator.kind == EditOperation::Growth);
    if (m_agesBox->isHidden())
        m_agesBox->setChecked(false);
    begin(like.params.grammar.seed + 1, m_hasNames);
    show();
    raise();
    activateWindow();
    m_choices.front()->setFocus();
}

std::int64_t SeedsDialog::seedOf(int choice) const
{
    constexpr int named = int(namedSeedCount);
    if (m_agesBox->isChecked())
        choice /= columns;
    if (!m_named)
        return m_first + choice;
    return choice < named ? (*namedSeeds(m_like.preset))[std::size_t(choice)] : m_first + choice - named;
}

Variation SeedsDialog::variationOf(int choice) const
{
    Variation variation{seedOf(choice), {}};
    if (m_agesBox->isChecked())
        variation.values.emplace_back(findParam("growth.age"), m_ages[std::size_t(choice % columns)]);
    return variation;
}

void SeedsDialog::begin(std::int64_t first, bool named)
{
    m_first = first;
    m_named = named;
    m_drawn = 0;
    m_problem.clear();
    for (PictureButton* choice : m_choices)
        choice->setPicture({});
    showTexts();
    drawNext();
}

/// Of three ages the oldest comes first: all are drawn to its scale.
int SeedsDialog::nextChoice() const
{
    return m_agesBox->isChecked() ? m_drawn + columns - 1 - 2 * (m_drawn % columns) : m_drawn;
}

void SeedsDialog::drawNext()
{
    if (m_drawn == count)
        return;
    const QSize size = m_choices.front()->pictureSize() * devicePixelRatioF();
    const int choice = nextChoice();
    if (m_drawn % columns == 0)
        m_scale.reset();
    const auto take = [this, choice](Expected<TreePicture>&& made) {
        if (!made) { // the others would not fare better
            m_problem = errorText(made.error());
            return showTexts();
        }
        if (m_agesBox->isChecked())
            m_scale = made->camera;
        m_choices[std::size_t(choice)]->setPicture(QPixmap::fromImage(std::move(made->image)));
        ++m_drawn;
        showTexts();
        drawNext();
    };
    const auto params = variedParams(m_like.params, variationOf(choice));
    m_pictures.draw(params.value_or(m_like.params), size, take, m_scale);
}

void SeedsDialog::choose(int choice)
{
    m_problem.clear();
    std::optional<Error> problem;
    const Variation chosen = variationOf(choice);
    if (m_tree == noNode) {
        Node tree = m_like;
        tree.params = variedParams(m_like.params, chosen).value_or(m_like.params);
        if (auto planted = edit::plantNode(*m_document, std::move(tree)); !planted)
            problem = std::move(planted.error());
    } else if (auto given =
                   edit::setParams(*m_document, {m_tree}, valuesOf(m_like.params, chosen, paramsOf({chosen})),
                                   tr("Give the tree seed %1").arg(chosen.seed));
               !given) {
        problem = std::move(given.error());
    }
    if (problem)
        m_problem = errorText(*problem);
    showTexts();
}

void SeedsDialog::showTexts()
{
    setWindowTitle(tr("More like %1").arg(presetTitle(QString::fromStdString(m_like.name))));
    const QString choose = m_tree == noNode ? tr("Click a tree to add it to the scene.")
                                            : tr("Click a tree: the one in the scene grows like it.");
    const QString chance =
        m_like.name.empty() || variesByChance(m_like.params)
            ? QString()
            : u' ' +
                  tr("Nothing but the places of its leaves varies: no rule has chances, and the variation of "
                     "angles, lengths and radii is 0 %.");
    m_hint->setText(!m_problem.isEmpty() ? m_problem
                    : m_drawn < count
                        ? choose + chance + u' ' + tr("Growing %1 of %2 …").arg(m_drawn + 1).arg(count)
                        : choose + chance);
    m_hint->setMinimumHeight(2 * fontMetrics().lineSpacing());
    for (int i = 0; i < count; ++i)
        m_choices[std::size_t(i)]->setText(textOf(i));
}

QString SeedsDialog::textOf(int choice) const
{
    const auto seed = std::size_t(m_agesBox->isChecked() ? choice / columns : choice);
    if (m_agesBox->isChecked())
        return tr("Seed %1, %n year(s)", "2, 40 years", int(m_ages[std::size_t(choice % columns)]))
            .arg(seedOf(choice));
    return m_named && seed < namedSeedCount
               ? tr("Seed %1: %2", "2: tall, wide …").arg(seedOf(choice)).arg(coreText(seedNames[seed]))
               : tr("Seed %1").arg(seedOf(choice));
}

/// Nobody sees what is not drawn yet.
void SeedsDialog::hideEvent(QHideEvent* event)
{
    m_pictures.stop();
    QDialog::hideEvent(event);
}

} // namespace ramure
