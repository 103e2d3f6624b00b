//! The book is read apart from the repository: what lies outside `docs/` is named in it, not linked.

use crate::page;
use mdbook_driver::book::{Book, BookItem};
use mdbook_driver::errors::Result;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use std::path::{Component, Path};

pub struct Outside;

impl Preprocessor for Outside {
    fn name(&self) -> &str {
        "outside"
    }

    fn run(&self, _: &PreprocessorContext, mut book: Book) -> Result<Book> {
        book.for_each_mut(|item| {
            if let BookItem::Chapter(chapter) = item
                && let Some(path) = &chapter.source_path
            {
                chapter.content = without_outside(&chapter.content, path);
            }
        });
        Ok(book)
    }
}

/// The page with the words of such links instead of the links.
fn without_outside(text: &str, page: &Path) -> String {
    let mut text = text.to_owned();
    for link in page::links(&text.clone()).into_iter().rev().filter(|link| leads_out(page, &link.to)) {
        let words = text[link.words].to_owned();
        text.replace_range(link.whole, &words);
    }
    text
}

/// Whether a link of a page leads out of the folder that the page's path begins in.
fn leads_out(page: &Path, to: &str) -> bool {
    let mut depth = page.components().count() as isize - 1;
    Path::new(to).components().any(|part| {
        depth += if part == Component::ParentDir { -1 } else { 1 };
        depth < 0
    })
}

#[cfg(test)]
mod tests {
    use super::without_outside;
    use std::path::Path;

    #[test]
    fn what_is_outside_is_only_named() {
        let text = "[in](../a.md), [`out`](../../b.rs) and [far](../../../c)";
        assert_eq!(without_outside(text, Path::new("guide/page.md")), "[in](../a.md), `out` and far");
        assert_eq!(without_outside("[x](../y)", Path::new("page.md")), "x");
    }
}
