//! The `validate` example as its user meets it: what it prints and writes, and what it says of bad input.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed", feature = "micromath"))]

#[path = "support/host.rs"]
mod host;
#[path = "support/scalars.rs"]
mod scalars;
#[allow(dead_code)]
#[path = "../examples/validate/tool/mod.rs"]
mod tool;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use scalars::NUMBERS;

/// A folder for one test.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let name = format!("carom-validate-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }

    fn file(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, content).expect("a file");
        path
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// The names of all files, sorted.
    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("a folder");
        let mut names: Vec<_> =
            entries.map(|e| e.expect("an entry").file_name().into_string().expect("text")).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// What a run leaves: status, standard output, standard error.
struct Ran {
    status: u8,
    out: String,
    err: String,
}

fn validate(arguments: &[&str]) -> Ran {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let status = tool::commands::run(["validate"].iter().chain(arguments), &mut out, &mut err);
    let text = |bytes| String::from_utf8(bytes).expect("text");
    Ran { status, out: text(out), err: text(err) }
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

fn scalar() -> String {
    NUMBERS[0].to_string()
}

const IMPULSES: &str = include_str!("data/two_body_impulse_dev.csv");
const LAWS: &str = include_str!("data/planar_impact_laws.csv");
/// In the form of the measured impacts.
const ELLIPSE: &str = "i,x0,y0,th0,vx0,vy0,w0,x1,y1,th1,vx1,vy1,w1,Jn_x,Jn_y,Jn_w,Jt_x,Jt_y,Jt_w,flags
7,0.3,0.04,-1.5,0.4,-2.8,-2.0,0.3,0.04,-1.5,0.4,1.7,10.7,0,1,0.001,1,0,0.035,000000
8,0.4,0.03,0.3,0.8,-2.6,-4.8,0.4,0.03,0.1,0.3,0.9,-40.6,0,1,-0.006,1,0,0.026,000000
9,0.4,0.03,0.3,0.8,0.6,-4.8,0.4,0.03,0.1,0.3,0.9,-40.6,0,1,-0.006,1,0,0.026,000000
";

/// Pairs that touch in plain numbers: apart, resting, turned by a quarter, and sunk in by the least of three ways.
const PAIRS: &str = "id,A,B,sizeA,sizeB,posA,quatA,posB,quatB,dist,normal
10,sphere,sphere,0.5,0.25,0 0 0,1 0 0 0,0 0 1,-2 0 0 0,0.25,0 0 1
11,box,plane,0.5 0.25 0.125,,0 0 0.125,3 0 0 0,0 0 0,1 0 0 0,0,0 0 -1
12,capsule,box,0.25 0.5,0.5 0.5 0.5,1.5 0 0,1 0 1 0,0 0 0,1 0 0 0,0.25,-1 0 0
13,box,box,1 1 1,0.5 0.5 0.5,0 0 0,1 0 0 0,0.25 0.5 1.25,1 0 0 0,-0.25,0 0 1
";

/// The header and the first rows.
fn head(file: &str, rows: usize) -> Vec<Vec<String>> {
    file.lines().take(rows + 1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn join(rows: &[Vec<String>]) -> String {
    rows.iter().map(|row| row.join(",") + "\n").collect()
}

/// With another text in one cell of the second row.
fn with(file: &str, column: &str, cell: &str) -> String {
    let mut rows = head(file, 3);
    let at = rows[0].iter().position(|name| name == column).expect("a column");
    rows[2][at] = cell.to_owned();
    join(&rows)
}

/// The run must fail with one line that says `expected`, leave standard output empty, and write nothing.
#[track_caller]
fn refused(mode: &str, content: impl AsRef<[u8]>, more: &[&str], expected: &[&str]) {
    let folder = Folder::new();
    let (file, out) = (folder.file("bad.csv", content), folder.path("out.csv"));
    let scalar = scalar();
    let mut arguments = vec![mode, text(&file), "--scalar", &scalar, "--out", text(&out)];
    arguments.extend(more);
    let ran = validate(&arguments);
    assert_eq!((ran.status, ran.out.as_str(), ran.err.lines().count()), (1, "", 1), "{}", ran.err);
    assert!(ran.err.starts_with("validate: "), "{}", ran.err);
    assert!(ran.err.contains("bad.csv"), "{}", ran.err);
    for part in expected {
        assert!(ran.err.contains(part), "{part:?} is not in {:?}", ran.err);
    }
    assert_eq!(folder.names(), ["bad.csv"]);
}

#[test]
fn results_come_out_with_all_their_digits() {
    let folder = Folder::new();
    let (file, out) = (folder.file("in.csv", join(&head(IMPULSES, 20))), folder.path("out.csv"));
    for number in NUMBERS {
        let ran = validate(&["impulses", text(&file), "--scalar", &number.to_string(), "--out", text(&out)]);
        assert_eq!((ran.status, ran.err.as_str()), (0, ""));
        assert_eq!(folder.names(), ["in.csv", "out.csv"]);
        let written = fs::read_to_string(&out).expect("results");
        let rows: Vec<Vec<&str>> = written.lines().map(|line| line.split(',').collect()).collect();
        let header = "id,jn,jt,vp1x,vp1y,vp1z,vp2x,vp2y,vp2z,wp1x,wp1y,wp1z,wp2x,wp2y,wp2z";
        assert_eq!((rows.len(), rows[0].join(",").as_str()), (21, header));
        let truth = head(IMPULSES, 20);
        for (found, right) in rows[1..].iter().zip(&truth[1..]) {
            assert_eq!(found[0], right[0]);
            for (column, cell) in rows[0].iter().zip(found).skip(1) {
                let at = truth[0].iter().position(|name| name == column).expect("a column");
                let (found, right): (f64, f64) =
                    (cell.parse().expect("a number"), right[at].parse().expect("a number"));
                assert!((found - right).abs() < 5e-3, "{number}, row {}, {column}: {found}, not {right}", right);
                assert_eq!(found.to_string(), *cell, "all digits");
            }
        }
    }
}

#[test]
fn the_report_tells_counts_errors_and_verdicts() {
    let folder = Folder::new();
    let file = folder.file("in.csv", join(&head(IMPULSES, 30)));
    let ran = validate(&["impulses", text(&file), "--scalar", &scalar()]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    for part in
        ["30 rows: 30 compared, 0 not representable, 0 failed", "category", "median", "p99", "max", "tolerances of"]
    {
        assert!(ran.out.contains(part), "{part:?} is not in\n{}", ran.out);
    }
    assert!(!ran.out.contains("EXCEEDED"), "{}", ran.out);
}

#[test]
fn columns_may_stand_in_any_order_and_others_among_them() {
    let folder = Folder::new();
    let rows = head(IMPULSES, 10);
    let plain = folder.file("plain.csv", join(&rows));
    let reversed: Vec<Vec<String>> = rows
        .iter()
        .map(|row| row.iter().rev().cloned().chain(["anything".to_owned() + &row[0]]).collect::<Vec<_>>())
        .collect();
    // As a spreadsheet writes it: a mark in front, two characters at the end of each line, blanks, an empty line.
    let text_of_it = "\u{feff}".to_owned() + &join(&reversed).replace(',', " , ").replace('\n', "\r\n") + "\r\n";
    let other = folder.file("other.csv", text_of_it);
    let written = [plain, other].map(|file| {
        let out = folder.path("out.csv");
        let ran = validate(&["impulses", text(&file), "--scalar", &scalar(), "--out", text(&out)]);
        assert_eq!((ran.status, ran.err.as_str()), (0, ""));
        fs::read_to_string(out).expect("results")
    });
    assert_eq!(written[0], written[1]);
}

#[test]
fn a_file_without_results_is_held_against_the_closed_form() {
    let folder = Folder::new();
    let mut rows = head(IMPULSES, 10);
    let inputs = rows[0].iter().position(|name| name == "Jx").expect("a column");
    let mode = rows[0].iter().position(|name| name == "mode").expect("a column");
    for row in &mut rows {
        row.truncate(inputs);
        row.remove(mode);
    }
    let file = folder.file("in.csv", join(&rows));
    let ran = validate(&["impulses", text(&file), "--scalar", &scalar()]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    assert!(ran.out.contains("10 compared"), "{}", ran.out);
}

#[test]
fn immovable_bodies_and_quaternions_of_any_length() {
    let folder = Folder::new();
    let mut rows = head(IMPULSES, 950);
    // Rows 800 to 899 have one immovable body each.
    let of_d: Vec<_> = rows.drain(1..).filter(|row| row[1] == "D").collect();
    rows.extend(of_d);
    assert_eq!(rows.len(), 101);
    let plain = folder.file("plain.csv", join(&rows));
    for row in &mut rows[1..] {
        for component in &mut row[12..20] {
            *component = (1e9 * component.parse::<f64>().expect("a number")).to_string();
        }
    }
    assert_eq!(&rows[0][12..20].join(","), "q1w,q1x,q1y,q1z,q2w,q2x,q2y,q2z");
    let long = folder.file("long.csv", join(&rows));
    let written = [plain, long].map(|file| {
        let out = folder.path("out.csv");
        assert_eq!(validate(&["impulses", text(&file), "--scalar", &scalar(), "--out", text(&out)]).status, 0);
        let written = fs::read_to_string(out).expect("results");
        let cells = written.lines().skip(1).flat_map(|line| line.split(',').skip(1));
        cells.map(|cell| cell.parse::<f64>().expect("a number")).collect::<Vec<_>>()
    });
    assert_eq!(written[0].len(), 1400);
    // The normalised components may differ in their last place.
    assert!(written[0].iter().zip(&written[1]).all(|(a, b)| (a - b).abs() < 1e-4 * a.abs().max(1.0)));
}

#[test]
fn a_wrong_result_exceeds_the_tolerances() {
    for number in NUMBERS {
        for (column, cell) in [("Jx", "1.25"), ("vp2x", "1.25"), ("wp1z", "-1.25")] {
            let folder = Folder::new();
            let (file, out) = (folder.file("in.csv", with(IMPULSES, column, cell)), folder.path("out.csv"));
            let ran = validate(&["impulses", text(&file), "--scalar", &number.to_string(), "--out", text(&out)]);
            assert_eq!((ran.status, ran.err.lines().count()), (1, 1), "{}", ran.out);
            assert!(ran.out.contains("EXCEEDED"), "{}", ran.out);
            assert_eq!(folder.names(), ["in.csv", "out.csv"], "the kernel's results are what they are");
        }
    }
}

#[test]
fn planar_results_are_in_si() {
    let folder = Folder::new();
    let (file, out) = (folder.file("in.csv", ELLIPSE), folder.path("out.csv"));
    for number in NUMBERS {
        let ran = validate(&["planar", text(&file), "--scalar", &number.to_string(), "--out", text(&out)]);
        assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{}", ran.out);
        for part in ["units of length, time and mass", "distance to the measured velocity", "not a bar"] {
            assert!(ran.out.contains(part), "{part:?} is not in\n{}", ran.out);
        }
        let written = fs::read_to_string(&out).expect("results");
        let rows: Vec<Vec<&str>> = written.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(rows[0], ["id", "jn", "jt", "vx", "vy", "w"]);
        let number_of = |row: usize, column: usize| rows[row][column].parse::<f64>().expect("a number");
        // Row 7: v_n' = -e v_n, whatever friction does. Row 9 moves away.
        let rebound = number_of(1, 4) + 0.001 * number_of(1, 5);
        assert!((rebound - 0.537 * (2.8 + 0.001 * 2.0)).abs() < 1e-4, "{number}: {rebound}");
        assert_eq!((rows[3][0], number_of(3, 1), number_of(3, 2)), ("9", 0.0, 0.0));
        let ran = validate(&[
            "planar",
            text(&file),
            "--scalar",
            &number.to_string(),
            "--mu",
            "0",
            "--restitution",
            "1",
            "--out",
            text(&out),
        ]);
        assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{}", ran.out);
        let written = fs::read_to_string(&out).expect("results");
        assert_eq!(written.lines().nth(1).and_then(|line| line.split(',').nth(2)), Some("0"), "no friction");
    }
}

#[test]
fn planar_laws_skip_what_is_no_impact() {
    let folder = Folder::new();
    let (file, out) = (folder.file("in.csv", LAWS), folder.path("out.csv"));
    let ran = validate(&["planar", text(&file), "--scalar", &scalar(), "--out", text(&out)]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{}", ran.out);
    assert!(ran.out.contains("rows without an impact: 5"), "{}", ran.out);
    assert_eq!(fs::read_to_string(out).expect("results").lines().count(), 231);
}

#[test]
fn distances_come_out_in_metres() {
    let folder = Folder::new();
    let (file, out) = (folder.file("in.csv", PAIRS), folder.path("out.csv"));
    for number in NUMBERS {
        for (more, length) in [(&[][..], 1.0), (&["--millimetres"], 1e-3), (&["--disguised"], 1.0)] {
            let number = number.to_string();
            let mut arguments = vec!["geometry", text(&file), "--scalar", &number, "--out", text(&out)];
            arguments.extend(more);
            let ran = validate(&arguments);
            assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{}", ran.out);
            for part in ["4 rows: 4 compared, 0 not representable, 0 failed", "signed distance", "tolerances of"] {
                assert!(ran.out.contains(part), "{part:?} is not in\n{}", ran.out);
            }
            let written = fs::read_to_string(&out).expect("results");
            let rows: Vec<Vec<&str>> = written.lines().map(|line| line.split(',').collect()).collect();
            assert_eq!(rows[0], ["id", "dist", "nx", "ny", "nz"]);
            let right = [("10", 0.25, [0., 0., 1.]), ("11", 0., [0., 0., -1.]), ("12", 0.25, [-1., 0., 0.])];
            for (row, (id, distance, normal)) in
                rows[1..].iter().zip(right.into_iter().chain([("13", -0.25, [0., 0., 1.])]))
            {
                assert_eq!(row[0], id);
                let cells: Vec<f64> = row[1..].iter().map(|cell| cell.parse().expect("a number")).collect();
                assert!((cells[0] / length - distance).abs() < 1e-4, "{number}, row {id}: {}", cells[0]);
                assert!(
                    cells[1..].iter().zip(normal).all(|(a, b)| (a - b).abs() < 1e-4),
                    "{number}, row {id}: {cells:?}"
                );
            }
        }
    }
}

#[test]
fn a_tied_axis_is_counted_and_a_wrong_normal_is_not() {
    // As deep along x as along z: both are right. Along y it is not.
    let tied = PAIRS.replacen("0.25 0.5 1.25", "1.25 0.5 1.25", 1);
    for (normal, status, ties) in [("0 0 1", 0, true), ("1 0 0", 0, true), ("0 1 0", 1, false)] {
        let folder = Folder::new();
        let file = folder.file("in.csv", tied.replacen("-0.25,0 0 1", &format!("-0.25,{normal}"), 1));
        let ran = validate(&["geometry", text(&file), "--scalar", &scalar()]);
        assert_eq!(ran.status, status, "{normal}: {}", ran.out);
        assert_eq!(ran.out.contains("EXCEEDED"), !ties, "{}", ran.out);
    }
    let folder = Folder::new();
    let counts = ["0 0 1", "1 0 0"].map(|normal| {
        let file = folder.file("in.csv", tied.replacen("-0.25,0 0 1", &format!("-0.25,{normal}"), 1));
        let ran = validate(&["geometry", text(&file), "--scalar", &scalar()]);
        usize::from(ran.out.contains("separates as well as the file's: 1"))
    });
    assert_eq!(counts[0] + counts[1], 1, "the other of the two");
}

#[test]
fn bad_pairs_are_refused() {
    refused("geometry", "a,b\n1,2\n", &[], &["missing columns id, A, B"]);
    refused("geometry", PAIRS.lines().next().expect("a header"), &[], &["has no rows"]);
    for (column, cell, problem) in [
        ("A", "cone", "\"cone\" is none of sphere, box, capsule, plane"),
        ("sizeA", "0.5 0.25", "is not 3 finite numbers"),
        ("sizeA", "0.5 0.25 0", "a size is not positive"),
        ("posB", "0 x 0", "is not 3 finite numbers"),
        ("posB", "0 NaN 0", "is not 3 finite numbers"),
        ("quatA", "0 0 0 0", "the quaternion is zero"),
        ("quatB", "1 0 0", "is not 4 finite numbers"),
        ("dist", "far", "is not a number"),
        ("normal", "0 0 2", "the normal is of length 2, not 1"),
    ] {
        refused("geometry", with(PAIRS, column, cell), &[], &["row 2 (line 3), column ", column, problem]);
    }
}

#[test]
fn bad_files_are_refused_in_one_line() {
    refused("impulses", "", &[], &["is empty"]);
    refused("impulses", join(&head(IMPULSES, 0)), &[], &["has no rows"]);
    refused("impulses", "a,b\n1,2\n", &[], &["missing columns id, cat, q16"]);
    refused("impulses", join(&head(IMPULSES, 2)).replacen("m2,", "mass2,", 1), &[], &["header: missing column m2\n"]);
    refused("impulses", join(&head(IMPULSES, 2)).replacen("vp2z,", "vz,", 1), &[], &["missing column vp2z\n"]);
    refused("impulses", join(&head(IMPULSES, 2)).replacen("m2,", "m1,", 1), &[], &["second with the name \"m1\""]);
    let rows = join(&head(IMPULSES, 2));
    refused("impulses", &rows[..rows.len() - 30], &[], &["row 2 (line 3), column", "the row ends before it"]);
    refused("impulses", rows.trim_end().to_owned() + ",1\n", &[], &["row 2 (line 3), column 62"]);
    let mut bytes = with(IMPULSES, "v2z", "\u{1}").into_bytes();
    bytes.iter_mut().filter(|byte| **byte == 1).for_each(|byte| *byte = 0xff);
    refused("impulses", bytes, &[], &["row 2 (line 3), column v2z: is not UTF-8"]);
}

#[test]
fn bad_numbers_are_refused_by_row_and_column() {
    for (column, cell, problem) in [
        ("m1", "abc", "\"abc\" is not a number"),
        ("m1", "", "is empty"),
        ("v2y", "NaN", "\"NaN\" is not a finite number"),
        ("w1z", "-inf", "is not a finite number"),
        ("r1x", "1e999", "is not a finite number"),
        ("Jx", "0x10", "is not a number"),
        ("m2", "-1", "-1 is negative"),
        ("I2y", "0", "0 is not positive"),
        ("I1x", "-0.5", "-0.5 is not positive"),
        ("I1z", "1e6", "exceeds the sum of the other two"),
        ("e", "1.0000001", "is outside 0 to 1"),
        ("mu", "-0.125", "is negative"),
        ("q16", "2", "is neither 0 nor 1"),
        ("mode", "sliding", "\"sliding\" is none of"),
        ("cat", "", "is empty"),
        ("vp1x", "1,5", "column 62"),
        ("m1", "a line that goes on and on and on and on and on and on and on", "...\" is not a number"),
        ("m1", "\"two\nlines\"", "is not a number"),
    ] {
        let expected = if cell.contains(',') { problem.to_owned() } else { format!("column {column}: ") };
        refused("impulses", with(IMPULSES, column, cell), &[], &["row 2 (line ", &expected, problem]);
    }
    let mut rows = head(IMPULSES, 2);
    rows[2][12..16].fill("0".to_owned());
    refused("impulses", join(&rows), &[], &["row 2 (line 3), column q1w: the quaternion is zero"]);
    let at = rows[0].iter().position(|name| name == "nx").expect("a column");
    rows[1][at..at + 3].fill("0".to_owned());
    refused("impulses", join(&rows), &[], &["row 1 (line 2), column nx: the normal is of length 0"]);
}

#[test]
fn bad_planar_files_are_refused() {
    refused("planar", "a,b\n1,2\n", &[], &["neither column Jn_w", "nor column newton_jn"]);
    refused("planar", ELLIPSE.replacen("w0", "w", 1), &[], &["missing column w0"]);
    refused("planar", with(ELLIPSE, "Jn_x", "0.1"), &[], &["row 2 (line 3), column Jn_x: 0.1 is not 0"]);
    refused("planar", with(ELLIPSE, "vy0", "fast"), &[], &["row 2 (line 3), column vy0: \"fast\" is not a number"]);
    refused("planar", with(ELLIPSE, "vx1", "nan"), &[], &["row 2 (line 3), column vx1"]);
    refused("planar", with(LAWS, "m", "0"), &[], &["row 2 (line 3), column m: 0 is not positive"]);
    refused("planar", with(LAWS, "newton_mode", "stuck"), &[], &["column newton_mode: \"stuck\" is none of"]);
    refused("planar", LAWS, &["--mu", "0.3"], &["--mu and --restitution are for measured impacts"]);
}

#[test]
fn bad_paths_are_refused() {
    let folder = Folder::new();
    let file = folder.file("in.csv", join(&head(IMPULSES, 3)));
    let scalar = scalar();
    let run = |file: &Path, out: &Path| {
        let ran = validate(&["impulses", text(file), "--scalar", &scalar, "--out", text(out)]);
        assert_eq!((ran.status, ran.out.as_str(), ran.err.lines().count()), (1, "", 1), "{}", ran.err);
        ran.err
    };
    let out = folder.path("out.csv");
    assert!(run(&folder.path("absent.csv"), &out).contains("absent.csv: cannot be read"));
    assert!(run(&folder.0, &out).contains("cannot be read"));
    assert!(run(&file, &folder.path("no/such/folder/out.csv")).contains("out.csv: cannot be written"));
    assert!(run(&file, &folder.0).contains("is not a file"));
    assert!(run(&file, &file).contains("--out would replace it"));
    assert_eq!(folder.names(), ["in.csv"]);
    assert_eq!(fs::read_to_string(&file).expect("the input"), join(&head(IMPULSES, 3)));
}

#[test]
fn a_command_line_that_makes_no_sense_is_told_in_one_line() {
    for arguments in [
        &["impulses"][..],
        &["impulses", "x.csv", "--scalar", "q15"],
        &["planar", "x.csv", "--mu", "-1"],
        &["planar", "x.csv", "--restitution", "2"],
        &["planar", "x.csv", "--mu", "much"],
        &["cubes", "x.csv"],
        &["impulses", "x.csv", "--rows"],
    ] {
        let ran = validate(arguments);
        assert_eq!((ran.status, ran.out.as_str(), ran.err.lines().count()), (2, "", 1), "{arguments:?}: {}", ran.err);
    }
    for arguments in [&["--help"][..], &["impulses", "--help"], &["planar", "--help"]] {
        let ran = validate(arguments);
        assert_eq!((ran.status, ran.err.as_str()), (0, ""), "{arguments:?}");
        assert!(ran.out.contains("Usage: validate"), "{}", ran.out);
    }
}
