//! Whether the links of all pages lead somewhere, and whether the book has all of `docs/`.

use crate::page;
use anyhow::{Context, Result};
use mdbook_driver::MDBook;
use mdbook_driver::book::BookItem;
use std::fs;
use std::path::{Path, PathBuf};

/// Folders with nothing of ours in them.
const FOREIGN: [&str; 3] = ["target", ".git", "node_modules"];

/// How many links were looked at, and those that lead nowhere.
pub struct Links {
    pub pages: usize,
    pub good: usize,
    pub broken: Vec<String>,
}

/// Looks at every link of every page of the repository that stays in it.
pub fn check(root: &Path) -> Result<Links> {
    let pages = pages(root)?;
    let mut links = Links { pages: pages.len(), good: 0, broken: Vec::new() };
    for page in pages {
        for link in page::links(&read(&page)?) {
            if leads_somewhere(&page, &link.to)? {
                links.good += 1;
            } else {
                links.broken.push(format!("{}: {}", page.display(), link.to));
            }
        }
    }
    Ok(links)
}

/// The pages of the folder that the book does not list.
pub fn unlisted(docs: &Path, book: &MDBook) -> Result<Vec<String>> {
    let listed: Vec<PathBuf> = book.iter().filter_map(source).map(|page| docs.join(page)).collect();
    let left_out = |page: &PathBuf| !listed.contains(page) && !page.ends_with("SUMMARY.md");
    Ok(pages(docs)?.into_iter().filter(left_out).map(|page| page.display().to_string()).collect())
}

fn source(item: &BookItem) -> Option<&PathBuf> {
    match item {
        BookItem::Chapter(chapter) => chapter.source_path.as_ref(),
        _ => None,
    }
}

fn leads_somewhere(page: &Path, to: &str) -> Result<bool> {
    let (file, anchor) = to.split_once('#').map_or((to, None), |(file, anchor)| (file, Some(anchor)));
    let target = if file.is_empty() { page.to_path_buf() } else { page.with_file_name(file) };
    let Some(anchor) = anchor else { return Ok(target.exists()) };
    Ok(target.is_file() && page::anchors(&read(&target)?).iter().any(|one| one == anchor))
}

/// All pages in a folder and below it.
fn pages(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| format!("reading {}", folder.display()))? {
        let path = entry?.path();
        let foreign = path.file_name().is_some_and(|name| FOREIGN.iter().any(|one| name == *one));
        if path.is_dir() && !foreign {
            found.extend(pages(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("reading {}", path.display()))
}
