//! The page in a real browser, on machines that have Chromium: no errors, nothing wider than the screen, and hover
//! and filters do what they should.

use super::tests::sample;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Runs before all else and collects what goes wrong.
const WATCH: &str = "<script>
const faults = [];
addEventListener('error', e => faults.push(e.message));
console.error = (...a) => faults.push(a.join(' '));
</script>";

/// Runs after all else: uses the page as a reader would, and tells the page around it what it saw.
const TRY: &str = "<script>
const see = {};
see.widths = [document.documentElement.scrollWidth, innerWidth];
const wide = [...document.querySelectorAll('main *')].filter(n => !n.closest('.scroll') && !n.closest('svg')
  && n.getBoundingClientRect().right > innerWidth + 0.5);
see.wide = wide.map(n => n.tagName + '.' + n.className).slice(0, 5);
const tip = document.getElementById('tip');
const mark = document.querySelector('.chart .p');
mark.scrollIntoView({ block: 'center', behavior: 'instant' });
const box = mark.getBoundingClientRect();
mark.closest('svg').dispatchEvent(new PointerEvent('pointermove',
  { clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 }));
see.tip = tip.hidden ? '' : tip.textContent;
const edge = tip.getBoundingClientRect();
see.tip_fits = edge.left >= 0 && edge.right <= innerWidth;
const front = document.querySelector('.front');
const before = front.getAttribute('d');
const box_of = document.querySelector(`[name=engine][value=${front.dataset.e}]`);
box_of.click();
see.front_off = front.getAttribute('d');
see.marks_off = [...document.querySelectorAll('.p.off')].length;
box_of.click();
see.front_back = front.getAttribute('d') === before;
const group = document.querySelector('[name=group]');
group.value = 'B';
group.dispatchEvent(new Event('change', { bubbles: true }));
see.scenes_off = [...document.querySelectorAll('.scene')].filter(n => n.offsetParent === null).length;
see.faults = faults;
parent.postMessage(JSON.stringify(see), '*');
</script>";

fn browser() -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let names = ["chromium", "chromium-browser", "google-chrome"];
    std::env::split_paths(&path).flat_map(|p| names.map(|n| p.join(n))).find(|p| p.is_file())
}

/// What the page tells in a frame of some width. A window of its own would not do: Chromium has none below 500 pixels.
fn see(browser: &Path, folder: &Path, width: u32) -> serde_json::Value {
    let around = format!(
        "<script>addEventListener('message', e => document.documentElement.setAttribute('data-see', e.data))</script>\
         <iframe src=\"page.html\" width=\"{width}\" height=\"844\" style=\"border:0\"></iframe>"
    );
    std::fs::write(folder.join("around.html"), around).unwrap();
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", "--virtual-time-budget=5000"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .args(["--hide-scrollbars", "--window-size=1400,900", "--timeout=30000"])
        .arg(format!("file://{}", folder.join("around.html").display()))
        .output()
        .unwrap();
    let dom = String::from_utf8_lossy(&output.stdout);
    let said = dom.split_once("data-see=\"").map(|(_, rest)| rest.split_once('"').unwrap().0);
    let said = said.unwrap_or_else(|| panic!("{}", String::from_utf8_lossy(&output.stderr)));
    serde_json::from_str(&said.replace("&quot;", "\"").replace("&lt;", "<").replace("&amp;", "&")).unwrap()
}

#[test]
fn the_page_works_on_a_phone_and_on_a_desk() {
    let Some(browser) = browser() else {
        eprintln!("no Chromium here: the page was not tried");
        return;
    };
    let folder = std::env::temp_dir().join(format!("merev-page-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut data = sample();
    data.scenes[1].group = "B".into();
    let page = super::page(&data).replacen("<head>", &format!("<head>{WATCH}"), 1);
    std::fs::write(folder.join("page.html"), page.replacen("</body>", &format!("{TRY}</body>"), 1)).unwrap();
    for width in [390, 1280] {
        let see = see(&browser, &folder, width);
        assert_eq!(see["faults"], serde_json::json!([]), "{see}");
        assert_eq!(see["widths"], serde_json::json!([width, width]), "{see}");
        assert_eq!(see["wide"], serde_json::json!([]), "{see}");
        assert!(see["tip"].as_str().unwrap().contains("merev, soft_step, f32"), "{see}");
        assert_eq!(see["tip_fits"], true, "{see}");
        assert_eq!((&see["front_off"], &see["front_back"]), (&"M0 0".into(), &true.into()), "{see}");
        assert_eq!((&see["marks_off"], &see["scenes_off"]), (&9.into(), &3.into()), "{see}");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}
