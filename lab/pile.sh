cd /tmp/ww; export CAROM_THUMB=debian CARGO_BUILD_JOBS=2
b=$1; s=$2
cargo xtask qemu zz_pile $b --scalar $s >/tmp/pile.log 2>&1 || cargo xtask qemu zz_pile --board $b --scalar $s > /tmp/pile.log 2>&1
case $b in
 m0) t=thumbv6m-none-eabi; m="microbit"; per=4.096;;
 m3) t=thumbv7m-none-eabi; m="mps2-an385"; per=6.4;;
 m4f) t=thumbv7em-none-eabihf; m="mps2-an386"; per=6.4;;
esac
elf=$(ls -t /tmp/ww/target/$t/release/examples/zz_pile /tmp/ww/target/*/$t/release/examples/zz_pile 2>/dev/null | head -1)
timeout 60 qemu-system-arm -machine $m -icount shift=8 -display none -serial none -monitor none -semihosting-config enable=on,target=native,arg=zz_pile,arg=--scalar,arg=$s -kernel $elf | awk -v per=$per '{for(i=1;i<=NF;i++) if ($i ~ /^[0-9]+$/ && $(i-1) ~ /total|begin|collide|add|finish|keep/) $i=int($i/per+.5); print}'
