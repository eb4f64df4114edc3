/// \file
/// A shown inspector of a document with one tree.
#pragma once

#include "core/skeleton/branch_facts.h"
#include "tests/widgets/tree_document.h"
#include "widgets/panels/inspector/branch_inspector.h"
#include "widgets/panels/inspector/fact_form.h"
#include "widgets/panels/inspector/section_browser.h"
#include <QLabel>

namespace ramure::test {

struct InspectorBench
{
    explicit InspectorBench(const NodeParams& params = smallForks())
    {
        tree = trees.add(params);
        inspector.resize(340, 700);
        inspector.show();
    }

    Document& document() { return trees.document(); }
    const Skeleton& skeleton() { return trees.skeleton(tree); }
    double rollOf(Index branch)
    {
        return edit::branchRolls(document(), tree, {skeleton().key[branch]}).front();
    }
    std::vector<SectionFacts> sections(Index branch)
    {
        return sectionFacts(skeleton(), *document().result(tree)->tree.sections, branch);
    }
    template <class Widget> Widget* part(const char* name)
    {
        return inspector.findChild<Widget*>(QLatin1String(name));
    }
    SectionBrowser* browser() { return inspector.findChild<SectionBrowser*>(); }
    FactForm* facts() { return inspector.findChildren<FactForm*>().front(); }
    /// The value beside a name of the branch's facts.
    QString fact(const QString& name)
    {
        for (int row = 0; row < facts()->rowCount(); ++row)
            if (facts()->name(row) == name)
                return facts()->value(row);
        return QStringLiteral("no fact of this name");
    }
    bool showsBranch() { return facts()->isVisible(); }
    /// The visible text without its fields and lists.
    QStringList visibleTexts()
    {
        QStringList texts;
        for (const QLabel* label : inspector.findChildren<QLabel*>())
            if (label->isVisible())
                texts += label->text();
        return texts;
    }

    TreeDocument trees;
    NodeId tree = noNode;
    BranchInspector inspector{&trees.document()};
};

} // namespace ramure::test
