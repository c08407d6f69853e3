//! docs/ARCHITECTURE.md stays true: imports run down from room to room, and in no circle inside a room.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The rooms of src in their order: each uses those of earlier rows only, and those of one row stand side by side.
const ORDER: [&[&str]; 10] = [
    &["error"],
    &["stored"],
    &["plane"],
    &["symm"],
    &["map"],
    &["formula", "riemann", "cortex"],
    &["mesh"],
    &["warp"],
    &["presets"],
    &["wasm"],
];

/// `warp::sampler::fold` as its parts; the crate's root has none.
type Module = Vec<String>;

/// The files of src by their modules, without comments and unit tests.
fn files() -> BTreeMap<Module, String> {
    fn collect(folder: &Path, module: &Module, files: &mut BTreeMap<Module, String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap().to_string();
            let inner = [module.as_slice(), std::slice::from_ref(&name)].concat();
            if path.is_dir() {
                collect(&path, &inner, files);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                let module = if name == "mod" || name == "lib" { module.clone() } else { inner };
                files.insert(module, text);
            }
        }
    }
    let mut files = BTreeMap::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &Vec::new(), &mut files);
    files
}

/// Code without comments, and without the tests at its end.
fn code(text: &str) -> String {
    let tests = text.find("#[cfg(test)]\nmod ").unwrap_or(text.len());
    text[..tests]
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .fold(String::new(), |all, line| all + line + "\n")
}

/// A path as it is written, and whether a `pub use` hands it on.
struct Mention {
    path: Vec<String>,
    is_export: bool,
}

/// Every path in the code that begins with `crate`, `super`, `self` or a child module, groups in braces taken apart.
fn mentions(code: &str, children: &BTreeSet<&str>) -> Vec<Mention> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(step) = code[at..].find("::") {
        let end = at + step;
        let begin = code[..end].rfind(|c| !is_name(c)).map_or(0, |k| k + 1);
        let first = &code[begin..end];
        let starts = ["crate", "super", "self"].contains(&first) || children.contains(first);
        // A macro's `$crate` stands for whoever uses the macro.
        if starts && !code[..begin].ends_with("::") && !code[..begin].ends_with('$') {
            let statement = code[..begin].rfind([';', '}']).map_or(0, |k| k + 1);
            let line = code[statement..begin].trim_start();
            let is_export = line
                .lines()
                .next_back()
                .is_some_and(|line| line.trim_start().starts_with("pub") && line.contains("use "));
            let mut paths = Vec::new();
            expand(&code[begin..], Vec::new(), &mut paths);
            found.extend(paths.into_iter().map(|path| Mention { path, is_export }));
        }
        at = end + 2;
    }
    found
}

/// `a::{b, c::d}` → a::b and a::c::d; gives how much of the text it was.
fn expand(text: &str, mut path: Vec<String>, found: &mut Vec<Vec<String>>) -> usize {
    let mut at = 0;
    loop {
        let name: String = text[at..].chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        at += name.len();
        if !name.is_empty() {
            path.push(name);
        }
        if text[at..].starts_with("::{") {
            at += 3;
            loop {
                at += text[at..].len() - text[at..].trim_start_matches([',', ' ', '\n']).len();
                if text[at..].starts_with('}') || text[at..].is_empty() {
                    return at + 1;
                }
                let used = expand(&text[at..], path.clone(), found);
                // `self as name` and whatever else a group may hold.
                at += used.max(1);
                at += text[at..].find([',', '}', '{']).unwrap_or(text[at..].len());
            }
        } else if text[at..].starts_with("::") && text[at + 2..].starts_with(|c: char| c.is_alphanumeric() || c == '_')
        {
            at += 2;
        } else {
            found.push(path);
            return at;
        }
    }
}

/// What each module hands on: name → where it comes from.
type Exports = BTreeMap<Module, BTreeMap<String, Module>>;

/// The module that a path leads to from `here`, through `pub use` where it goes that way.
fn resolve(path: &[String], here: &Module, files: &BTreeMap<Module, String>, exports: &Exports) -> Module {
    let mut module = here.clone();
    let mut rest = path;
    while let Some((name, after)) = rest.split_first() {
        match name.as_str() {
            "crate" => module.clear(),
            "self" => {}
            "super" => {
                module.pop();
            }
            name => {
                let child = [module.as_slice(), &[name.to_string()]].concat();
                if files.contains_key(&child) {
                    module = child;
                } else {
                    return exports.get(&module).and_then(|names| names.get(name)).unwrap_or(&module).clone();
                }
            }
        }
        rest = after;
    }
    module
}

/// Module → the modules that its code uses.
fn imports() -> BTreeMap<Module, BTreeSet<Module>> {
    let files = files();
    let mut mentioned = BTreeMap::new();
    for (module, text) in &files {
        let is_child = |other: &&Module| other.len() == module.len() + 1 && other.starts_with(module);
        let children = files.keys().filter(is_child).map(|child| child[module.len()].as_str()).collect();
        mentioned.insert(module.clone(), mentions(&code(text), &children));
    }
    let mut exports = Exports::new();
    // Twice, for what is handed on by two rooms in turn.
    for _ in 0..2 {
        for (module, mentions) in &mentioned {
            for mention in mentions.iter().filter(|mention| mention.is_export) {
                let (Some(name), target) = (mention.path.last(), resolve(&mention.path, module, &files, &exports))
                else {
                    continue;
                };
                exports.entry(module.clone()).or_default().insert(name.clone(), target);
            }
        }
    }
    let uses = |(module, mentions): (&Module, &Vec<Mention>)| {
        let used = mentions.iter().filter(|mention| !mention.is_export);
        let targets = used.map(|mention| resolve(&mention.path, module, &files, &exports));
        (module.clone(), targets.filter(|target| target != module && !target.is_empty()).collect())
    };
    mentioned.iter().filter(|(module, _)| !module.is_empty()).map(uses).collect()
}

#[test]
fn imports_run_down_from_room_to_room() {
    let level = |room: &str| {
        ORDER
            .iter()
            .position(|row| row.contains(&room))
            .unwrap_or_else(|| panic!("src/{room} has no place in the order"))
    };
    let imports = imports();
    let up: BTreeSet<String> = imports
        .iter()
        .flat_map(|(module, targets)| targets.iter().map(move |target| (module, target)))
        .filter(|(module, target)| module[0] != target[0] && level(&target[0]) >= level(&module[0]))
        .map(|(module, target)| format!("{} uses {}", module.join("::"), target.join("::")))
        .collect();
    assert!(up.is_empty(), "{up:#?}");
    // The reader of imports reads them: rooms that are known to build on each other.
    for (room, below) in
        [("symm", "plane"), ("riemann", "symm"), ("mesh", "riemann"), ("wasm", "warp"), ("plane", "error")]
    {
        let seen = imports.iter().filter(|(module, _)| module[0] == room).any(|(_, t)| t.iter().any(|t| t[0] == below));
        assert!(seen, "{room} is not seen to use {below}");
    }
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let imports = imports();
    let reach = |from: &Module| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(module) = open.pop() {
            for target in imports.get(module).into_iter().flatten() {
                if seen.insert(target) {
                    open.push(target);
                }
            }
        }
        seen
    };
    let reached: BTreeMap<&Module, BTreeSet<&Module>> = imports.keys().map(|module| (module, reach(module))).collect();
    let circles: BTreeSet<Vec<String>> = reached
        .iter()
        .filter(|(module, seen)| seen.contains(*module))
        .map(|(module, seen)| {
            let mates = seen.iter().filter(|mate| reached.get(*mate).is_some_and(|back| back.contains(*module)));
            mates.map(|mate| mate.join("::")).collect()
        })
        .collect();
    assert!(circles.is_empty(), "{circles:#?}");
}

#[test]
fn no_folder_holds_a_fifth_of_the_lines() {
    let mut lines = BTreeMap::<String, usize>::new();
    for (module, text) in files() {
        // A folder's own files, and those of folders from the second level on together.
        let folder = if Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(module.join("/")).is_dir() {
            module.clone()
        } else {
            module[..module.len() - 1].to_vec()
        };
        *lines.entry(folder[..folder.len().min(2)].join("/")).or_default() += text.lines().count();
    }
    let all: usize = lines.values().sum();
    let (folder, most) = lines.iter().max_by_key(|(_, count)| **count).unwrap();
    assert!(5 * most < all, "src/{folder} holds {most} of {all} lines");
}
