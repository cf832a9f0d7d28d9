# A bottling line: conveyor, filler, capper, and a tank that is heated.
# Written for the tests of ladder: every construct of the DSL is here.
def main():
    # Inputs
    if x[1]:
        out(c.StartPressed)

    # a closed contact in the field
    if nc(x.EmergencyStop):
        out(c.EStopActive)

    if all(c.StartPressed, nc(c.EStopActive), sc[1]):
        set(c.Running)

    if any(x.StopButton, c.EStopActive, all(t.NoBottle, nc(c.Manual))):
        reset(c.Running)

    if all(c[1:5], nc(c[5:9])):
        out(y[1:4])

    # Edges and one-shots
    if fe(x[2]):
        out(c.GateClosed, oneshot=True)
        set(c[20:24])
        reset(c[30:34])

    # Timers
    if c.Running:
        ton(t.Warm, setpoint=ds.WarmSeconds, unit=Ts)
        tof(t.NoBottle, setpoint=1500, unit=Tms)
        ton(t[7], setpoint=ds[7], unit=Tms)
        rton(t.Service, setpoint=8, unit=Th, reset=lambda: c.ServiceDone)
        rtof(t.Cooling, setpoint=ds.CoolMinutes, unit=Tm, reset=lambda: all(c.ServiceDone, nc(x[3])))

    # Counters
    if re(x.BottleSensor):
        ctu(ct.Bottles, setpoint=dd.BatchSize, reset=lambda: c.NewBatch)
        ctud(ct.InCapper, setpoint=3, count_down=lambda: x.CapperExit)  # the DSL gives it no reset
        ctd(ct[2], setpoint=24, reset=lambda: any(c.NewBatch, c.NewCrate))

    if all(ct.Bottles, td.Warm >= 5, ctd.Bottles > 0):
        out(y.BatchDone)

    # Data
    if c.Refresh:
        copy(0, ds.Level)
        copy(ds[10], dd.Total, oneshot=True)
        copy(dd.Total, ds[11])
        copy(0xFF, dh.Mask)
        copy(1.5, df.Factor)
        copy("OK", txt[1])
        copy(ds[ds.Step], ds[ds.Target])
        copy(0, td.Service)
        copy_block(ds[1:5], ds[100])  # four words
        copy_fill(0, df[20:30])
        copy_fill(ds.Level, ds[200:210], oneshot=True)
        copy_pack(c[101:117], dh.Status)
        copy_pack(txt[1:5], ds.Parsed)
        copy_unpack(dd.Config, c[201:233])

    # Recipes
    if all(ds.Mode == 1, df.Temperature <= 82.5, dh.Status != 0x8000):
        search("ge", ds.Level, ds[100], ds[199], ds.Found, c.FoundOne)
        search("eq", 7, dd[1], dd[50], ds.FoundSeven, c.FoundSeven, continuous=True, oneshot=True)

    if True:
        calc("(ds.Raw - 4) * 100 / 16", ds.Percent)
        calc("SQRT(df.Flow ^ 2) * PI + SUM(df[1:5])", df.Volume)
        calc("dd.Total + ds.Percent MOD 7", dd.Total, one_shot=True)
        math_hex("(dh.Status AND 0xFF) SHL 8 OR dh.Mask", dh.Word)
        math_hex("dh.Status + 1", dh.Next)

    # The tracking register
    if re(c.Step):
        shift(c[301:317])

    # A loop over the heaters
    if c.Running:
        for _ in range(ds.Heaters):  # up to next_loop()
            pass

    if ds.Temperature < ds.Wanted:
        copy(1, ds.Heat)

    if True:
        next_loop()

    if sc[2]:
        call(first_scan)

    if c.Manual:
        pass

    if c.Halt:
        end()

    # The end of the scan
    if True:
        end()


# Runs once.
# Sets what the program starts from.
@sub
def first_scan():
    if c.Cold:
        return

    if all(sc.FirstScan, c.Ready):
        copy(500, ds.Wanted)

    if True:
        return

    # nothing after it
