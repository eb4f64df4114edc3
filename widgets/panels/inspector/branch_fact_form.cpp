#include "widgets/panels/inspector/branch_fact_form.h"

#include "widgets/base/texts/fact_text.h"
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {
namespace {

enum Row {
    Parent,
    Children,
    Order,
    Start,
    End,
    StartRadius,
    EndRadius,
    Length,
    Angle,
    Azimuth,
    Mass,
    rowTotal
};

/// A branch with a hundred children is real; a label with a hundred links helps nobody.
constexpr std::size_t mostLinks = 24;
constexpr int pointDecimals = 3;

QString link(Index branch)
{
    return QStringLiteral("<a href=\"%1\">%1</a>").arg(branch);
}

} // namespace

BranchFactForm::BranchFactForm(QWidget* parent)
    : QWidget(parent)
    , m_form(new FactForm(rowTotal, this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_form);
    connect(m_form, &FactForm::linkActivated, this, [this](const QString& target) {
        bool number = false;
        const Index branch = target.toUInt(&number);
        if (number)
            emit branchChosen(branch);
    });
    m_form->setName(Parent, tr("Parent"), tr("The branch at whose end this one starts. Click to select it."));
    m_form->setName(Children, tr("Children"),
                    tr("The branches that start at this one's end. Click to select one."));
    m_form->setName(Order, tr("Order"),
                    tr("How many brackets of the grammar are around the branch: 0 is the trunk."));
    m_form->setName(Start, tr("Start (p0)"), tr("In the tree's space, Y up."));
    m_form->setName(End, tr("End (p1)"), tr("In the tree's space, Y up."));
    m_form->setName(StartRadius, tr("Start radius (a0)"));
    m_form->setName(EndRadius, tr("End radius (a1)"));
    m_form->setName(Length, tr("Length"), tr("From the start straight to the end."));
    m_form->setName(
        Angle, tr("Angle to the parent"),
        tr("Between the branch's direction and its parent's; of a root, between it and up (+Y)."));
    m_form->setName(
        Azimuth, tr("Azimuth"),
        tr("Which way the branch leans around its parent: from the normal of the parent's last section "
           "towards its binormal. A root is measured from +X towards −Z."));
    m_form->setName(
        Mass, tr("Mass"),
        tr("For the movement in the wind, without unit: the radius at the end, 0.075 for an apple, and the "
           "masses of all it carries."));
    showFacts();
}

void BranchFactForm::setFacts(const BranchFacts& facts)
{
    m_facts = facts;
    showFacts();
}

void BranchFactForm::setAngleUnit(AngleUnit unit)
{
    m_unit = unit;
    showFacts();
}

void BranchFactForm::showFacts()
{
    if (m_facts.parent == noIndex)
        m_form->setValue(Parent, tr("none: a root"));
    else
        m_form->setRichValue(Parent, link(m_facts.parent));
    if (m_facts.children.empty()) {
        m_form->setValue(Children, tr("none: a tip"));
    } else {
        QStringList links;
        const std::size_t shown = std::min(m_facts.children.size(), mostLinks);
        for (std::size_t i = 0; i < shown; ++i)
            links += link(m_facts.children[i]);
        QString text = links.join(QStringLiteral(", "));
        if (shown < m_facts.children.size())
            text += QLatin1Char(' ') +
                    tr("and %n more", nullptr, static_cast<int>(m_facts.children.size() - shown));
        m_form->setRichValue(Children, text);
    }
    m_form->setValue(Order, QString::number(m_facts.order));
    m_form->setValue(Start, facttext::point(m_facts.p0, pointDecimals));
    m_form->setValue(End, facttext::point(m_facts.p1, pointDecimals));
    m_form->setValue(StartRadius, facttext::length(m_facts.a0));
    m_form->setValue(EndRadius, facttext::length(m_facts.a1));
    m_form->setValue(Length, facttext::length(m_facts.length));
    m_form->setValue(Angle, facttext::angle(m_facts.angleRad, m_unit));
    m_form->setValue(Azimuth, facttext::angle(m_facts.azimuthRad, m_unit));
    m_form->setValue(Mass, facttext::number(m_facts.mass, 4));
}

} // namespace ramure
